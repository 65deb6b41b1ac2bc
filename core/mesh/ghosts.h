// SPDX-License-Identifier: MIT
/// \file
/// The ghost faces of a bare boundary: where they are, and where they start.
///
/// Let all faces at the boundary be quads. The ghosts at a boundary vertex V with k faces are chosen so that the limit
/// surface is that of Catmull-Clark with the boundary's rules (a cubic B-spline along the boundary, corners k = 1
/// interpolated) where that is smooth. With Pa, P1, ..., Pb the surface's spokes at V counterclockwise, Pa and Pb on
/// the boundary, and Q1, ..., Qk its faces' points opposite V:
///   k = 2: one ghost point, 2 V - P1.
///   k = 1, a corner: 2 V - Pa, 2 V - Pb, and diagonally 4 V - 2 Pa - 2 Pb + Q1.
///   k >= 3, where the standard boundary is not smooth: V becomes a vertex of valence 2 k with the spokes mirrored.
///   With
///     T = (Pa - Pb) / 2, E = (Pa + Pb) / 2 - V and t_j = pi j / k,
///       G_j = 2 (V + cos t_j T + cos^2 t_j E) - P_j,
///     and the points opposite V of the inner ghosts likewise, from Q_j, with cos t_(j-1/2) / cos(pi / 2k).
/// Neighbours of V on the boundary must have k = 2, as they have after an ordinary step; they are Pa and Pb, and their
/// ghost points close the outer ones of V's ghost faces. The start only: in an optimization ghosts are unknowns.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "mesh/polygon_mesh.h"

namespace umbilic {

struct Ghosts {
  std::vector<std::array<int, 4>> quads;  ///< corners: vertices of the mesh, then the new points
  int count = 0;                          ///< number of new points
  /// The new points as combinations of the mesh's vertices; rows are numbered as the points are.
  std::vector<Eigen::Triplet<double>> stencil;
};

/// Ghosts for each loop of the boundary on which `wanted` vertices lie; no ghosts of the mesh may be there already. The
/// new points are numbered from `first_new` on.
Ghosts make_ghosts(const PolygonMesh& mesh, const std::vector<bool>& wanted, int first_new);

}  // namespace umbilic
