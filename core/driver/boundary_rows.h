// SPDX-License-Identifier: MIT
/// \file
/// Conditions at the boundary of an open surface as equations that are linear in the control points.
///
/// Across a regular boundary vertex lie a ghost point G, the boundary point P0 and an inner point P1. The surface has
/// there, as functions along the boundary, cubic B-splines with the control points
///   C = (G + 4 P0 + P1) / 6   of the boundary curve (position),
///   D = (P1 - G) / 2          of the derivative across it (tangent),
///   E = G - 2 P0 + P1         of the second derivative across it (curvature).
/// Refinement maps these functions to themselves, so what is held means the same on every level.
///
/// At corners where four faces meet (one of the surface: convex, three: concave) the rows and the columns of the
/// control net are held through the ghosts' rows and columns. Some of these equations follow from others. At a vertex
/// of k >= 3 faces that ghosts mirror, the surface is determined by the ring of 2 k faces around it: tangent and
/// curvature hold all its points; the boundary curve depends on the vertex, its neighbours on the boundary, and the
/// sums of the other points and their mirror images. Where holes leave any other number of faces around a vertex, each
/// condition but free holds all points of its ring.
#pragma once

#include <vector>

#include "base/result.h"
#include "mesh/polygon_mesh.h"
#include "mesh/symmetry.h"
#include "problem/boundary_condition.h"

namespace umbilic {

/// The boundary's loops in the order of their first vertices: that in which reports of a cage and constraints number
/// them. Refinement does not change it.
std::vector<std::vector<int>> numbered_loops(const PolygonMesh& mesh);

/// The condition at each half-edge of the mesh of the cage, where that has the boundary on its right. Empty for closed
/// meshes. `held` says of each face whether it is held; it may be empty. What is listed is copied to where the
/// symmetries map it, which is all elements of a group or none. Errors name a loop or a vertex that the cage does not
/// have, copies that meet another listed condition, and curvature where neither ghosts of the cage nor held faces give
/// one.
Result<std::vector<BoundaryCondition>> boundary_conditions(const BoundaryConditions& conditions,
                                                           const PolygonMesh& mesh, const std::vector<bool>& held,
                                                           const std::vector<Symmetry>& symmetries = {});

/// The same on `finer`, the mesh after one Catmull-Clark step.
std::vector<BoundaryCondition> refined(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh,
                                       const PolygonMesh& finer);

/// Whether something is held at some boundary of the mesh.
bool holds_boundary(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh);

/// Whether the mesh has boundaries, and tangents are held at all of them: then their geodesic curvature cannot change
/// (but for what caps at vertices of three faces and more make of it).
bool holds_tangents(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh);

/// A combination of control points that is held.
struct PointRow {
  std::vector<int> points;
  std::vector<double> weights;
  int vertex;  ///< of the boundary
};

/// All that the conditions hold. The mesh needs ghosts along every boundary that is not free.
std::vector<PointRow> boundary_rows(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh);

}  // namespace umbilic
