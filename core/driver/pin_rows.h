// SPDX-License-Identifier: MIT
/// \file
/// Pins as equations that are linear in the control points.
///
/// A limit point is a linear function of the control points, so a held coordinate is one equation. So are the tangents:
/// a normal n is held by n . X_u = 0 and n . X_v = 0, with n fixed. What is held lies on S, the limit surface without
/// caps; that surface does not change under refinement, so a held point means the same on every level.
///
///     Result<std::vector<HeldPoint>> held = hold(problem.constraints.pins, cage);  // cage at level 0
///     held = refined(held, mesh);                                        // for the points after one step, and so on
///     const PinRows rows = pin_rows(*held, mesh);
///     AffineSubspace solutions(in_coordinates(rows.rows, coordinates), start);
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "driver/held_point.h"
#include "driver/surface.h"
#include "mesh/coordinates.h"
#include "problem/pin.h"
#include "solve/affine_subspace.h"
#include "surface/limit_stencil.h"

namespace umbilic {

/// The pins on a cage at level 0. Targets that are not given are those of its surface S. Errors name the pin's member:
/// "constraints.pins[2].vertex: 99, but the cage has 8 vertices".
Result<std::vector<HeldPoint>> hold(const std::vector<Pin>& pins, const RefinedCage& cage);

/// The same points on catmull_clark_mesh(mesh).
std::vector<HeldPoint> refined(std::vector<HeldPoint> held, const PolygonMesh& mesh);

/// What an equation holds of which point.
struct PinRow {
  int pin;          ///< index among the held points; -1 if it is that of a boundary
  int coordinate;   ///< 0 to 2: of the position; 3, 4: n . X_u, n . X_v
  int vertex = -1;  ///< of the boundary
};

/// Equations over the coordinates 3 v + c of the control points.
struct PinRows {
  LinearRows rows;
  std::vector<PinRow> owners;  ///< of each row
};
PinRows pin_rows(const std::vector<HeldPoint>& held, const PolygonMesh& mesh);

/// Rows over the control points as rows over the unknowns of `coordinates`.
LinearRows in_coordinates(const LinearRows& rows, const Coordinates& coordinates);

/// The force with which the pin pulls the surface, from the multipliers of the rows: the derivative of the minimal
/// energy by the pin's position, in unit coordinates. Divided by 2^exponent of the placement it is one by the cage's
/// own length.
Vector3 pull(const PinRows& rows, const Eigen::VectorXd& multipliers, int pin);

/// The pins whose normals are held, but now point inward: the equations do not tell n from -n.
std::vector<int> turned_over(const std::vector<HeldPoint>& held, const PolygonMesh& mesh, const Points& control);

/// Whether the symmetry, about `center`, maps the pins with what they hold to one another: then equal forces keep a
/// symmetric surface symmetric. Targets may differ by 1e-10 of the size, what exact equations can bear.
bool keeps(const Symmetry& symmetry, const Vector3& center, const std::vector<HeldPoint>& held,
           const PolygonMesh& mesh);

/// The pins, and what the symmetries, about `center`, map them to, without what is there already. Fails where a
/// symmetry does not map coordinates that are held to coordinates.
Result<std::vector<HeldPoint>> with_images(const std::vector<HeldPoint>& held, const std::vector<Symmetry>& symmetries,
                                           const Vector3& center, const PolygonMesh& mesh);

}  // namespace umbilic
