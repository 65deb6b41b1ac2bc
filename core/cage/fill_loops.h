// SPDX-License-Identifier: MIT
/// \file
/// The boundary loops of a cage.
#pragma once

#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// The vertices of each loop, in the order in which the surface lies to the left. Loops are in the order of their
/// smallest vertices, and begin with them. Faces marked as holes do not count as surface.
std::vector<std::vector<int>> loops_to_fill(const Cage& cage);

}  // namespace umbilic
