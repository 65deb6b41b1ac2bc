// SPDX-License-Identifier: MIT
/// \file
/// Counts the elements, loops and groups of a cage that has been checked.
#pragma once

#include <vector>

#include "cage/cage.h"
#include "cage/edges.h"

namespace umbilic {

/// The counts of a manifold cage, of which the vertices that no face uses are not counted. `loops` are its boundary
/// loops; their first vertices are reported zero-based. Repairs and notes stay empty.
CageReport count(const Cage& cage, const std::vector<EdgeUse>& uses, const Orientation& orientation,
                 const std::vector<std::vector<int>>& loops);

}  // namespace umbilic
