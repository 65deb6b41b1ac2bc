// SPDX-License-Identifier: MIT
/// \file
/// The elements of a mesh's symmetry group, and those that keep something besides the mesh, such as what a user holds.
#pragma once

#include <functional>

#include "mesh/symmetry.h"

namespace umbilic {

/// The subgroup of the elements for which `keeps` holds. These must form a group, as those do that map something to
/// itself. The subgroup has the center and the exact isometries of the group.
///
/// All elements are listed, each with its map of the half-edges. For groups so large that this would take more than
/// kMostListedHalfedges, the result is C1 and not `complete`.
SymmetryGroup subgroup(const SymmetryGroup& group, const PolygonMesh& mesh,
                       const std::function<bool(const Symmetry&)>& keeps);

inline constexpr double kMostListedHalfedges = 3e7;

/// All elements of the group, the identity first; none where there are more than `subgroup` lists.
std::vector<Symmetry> elements_of(const SymmetryGroup& group, const PolygonMesh& mesh);

}  // namespace umbilic
