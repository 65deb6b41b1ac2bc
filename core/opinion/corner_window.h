// SPDX-License-Identifier: MIT
/// \file
/// The control points that the limit surface over one quad depends on, where one corner of the quad may have any
/// valence; and their refinement towards that corner, by the rules for face, edge and vertex points.
///
/// The quad is the square [0, 1]^2 of a grid with the corner at the origin. Sector j of N of the corner lies between
/// the spokes j and j + 1; the quad is sector 0. Points of the other sectors that the surface does not depend on are
/// not asked for.
#pragma once

#include <array>
#include <vector>

#include "mesh/polygon_mesh.h"
#include "opinion/bicubic.h"

namespace umbilic::opinion {

class CornerWindow {
 public:
  /// Of the face of h, whose corner is the origin of h. All faces at the corner are quads, and so are those around the
  /// face. Its three other corners have valence 4.
  CornerWindow(const PolygonMesh& mesh, const Points& control, int h);

  /// From `spoke[j]`, the first point along spoke j, `diagonal[j]`, the point opposite the corner in sector j, and
  /// `outer`: the grid's points (2, -1), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (-1, 2).
  CornerWindow(const Vector3& corner, std::vector<Vector3> spoke, std::vector<Vector3> diagonal,
               const std::array<Vector3, 7>& outer);

  /// Replaces the quad by its quarter at the corner. Points are kept relative to the corner, so that what is small
  /// there keeps its digits.
  void step();

  /// After a step: the control points of the quarters (i, j) = (1, 0), (0, 1) and (1, 1), which are regular, relative
  /// to `corner`.
  Grid quarter(int i, int j) const;
  const Vector3& corner() const { return corner_; }

  int valence() const { return static_cast<int>(spoke_.size()); }
  const Vector3& spoke(int j) const { return spoke_[j]; }  ///< relative to `corner`

 private:
  Vector3& at(int a, int b) { return grid_[a + 1][b + 1]; }
  const Vector3& at(int a, int b) const { return grid_[a + 1][b + 1]; }
  void put_ring_in_grid();

  Vector3 corner_ = Vector3::Zero();  // where the origin is; all other points are relative to it
  std::vector<Vector3> spoke_, diagonal_;
  std::array<std::array<Vector3, 5>, 5> grid_{};  // (a, b) from -1 to 3; before a step to 2
};

/// The limit surface, without caps, at (u, v) of the face of h, u along h. The face has one extraordinary vertex at
/// most; (u, v) is not there.
TaylorPoint limit_point(const PolygonMesh& mesh, const Points& control, int h, double u, double v);

/// The control points of a face whose corners and their faces are regular, u along h.
Grid regular_grid(const PolygonMesh& mesh, const Points& control, int h);

}  // namespace umbilic::opinion
