// SPDX-License-Identifier: MIT
/// \file
/// The limit surface as a quad mesh with normals and principal curvatures, for viewing and for files.
#pragma once

#include <array>
#include <vector>

#include "cage/placement.h"

namespace umbilic {

/// Vertices that neighbouring patches share occur once, so the mesh is closed like the surface.
struct LimitMesh {
  Points positions;
  Points normals;  ///< unit, outward
  /// Principal curvatures kappa1 >= kappa2, one row each; positive where the surface bends away from the outward
  /// normal, as a sphere does.
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> curvatures;
  /// Energy per area at each vertex, in 1/length^2, where it was asked for; else empty. See EnergyDensity.
  Eigen::VectorXd densities{};
  std::vector<std::array<int, 4>> quads{};
  /// Of each patch: the face of the cage that it descends from. Each has equally many quads, in the order of patches.
  std::vector<int> cage_faces{};
};

/// From unit coordinates back to those of the cage that has the placement.
void put_back(LimitMesh& mesh, const Placement& placement);

}  // namespace umbilic
