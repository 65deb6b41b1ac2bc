// SPDX-License-Identifier: MIT
/// \file
/// The boundary loops of a cage: the closed chains of edges that have a face on one side only; and those of its
/// surface, which has no points over holes.
#pragma once

#include <vector>

#include "cage/cage.h"
#include "cage/edges.h"

namespace umbilic {

/// The vertices of each boundary loop of a validated cage, in the order in which the surface lies to the left of one
/// who walks on its outside: that in which the loop's faces name them. Each loop begins with its vertex of the smallest
/// number, and the loops are in the order of their first vertices. A vertex is in one loop at most, and only once.
///
/// The square with corners 0, 1, 2, 3 has the loop 0, 1, 2, 3. A face that fills a loop names its vertices in the
/// opposite order.
std::vector<std::vector<int>> boundary_loops(const Cage& cage);

/// The same where the open edges are known, by `open_uses`. Whether `forward` is true for them does not matter.
std::vector<std::vector<int>> boundary_loops(const Cage& cage, const std::vector<EdgeUse>& open);

/// The cage's vertices, and its faces but those marked as holes; without groups.
Cage without_holes(const Cage& cage);

/// The boundary loops of the surface of a validated cage, as `boundary_loops`: those that the constraints of a problem
/// number.
std::vector<std::vector<int>> surface_boundaries(const Cage& cage);

}  // namespace umbilic
