// SPDX-License-Identifier: MIT
/// \file
/// Which quads fill a loop: the corners of the patch, and whether a ring of quads comes first. See fill.h.
#pragma once

#include <optional>
#include <vector>

#include "base/types.h"

namespace umbilic {

struct FillPattern {
  bool ring = false;         ///< a ring of quads as long as the loop comes before the patch
  std::vector<int> corners;  ///< positions on the loop, rising
};

/// The numbers a_i of edges from the middle of an s-sided patch to the middles of its sides, where `sides` are the
/// numbers of edges from each corner to the next: the corner i lies between the spokes i and i + 1, so that
/// sides[i] = a_i + a_{i+2}. Empty if no positive numbers do. Among several solutions, which only s divisible by 4 has,
/// it is the middle one.
std::vector<int> spokes_of(const std::vector<int>& sides);

/// The numbers of edges between consecutive corners on a loop of `length` edges.
std::vector<int> sides_between(const std::vector<int>& corners, int length);

/// Whether a patch with these sides exists.
bool is_patch(const std::vector<int>& sides);

/// The pattern for the loop of these points, where `faces[i]` faces of the surface are around the vertex i. Empty if
/// the cage must be refined first.
std::optional<FillPattern> fill_pattern(const std::vector<Vector3>& points, const std::vector<int>& faces);

}  // namespace umbilic
