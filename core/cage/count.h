// SPDX-License-Identifier: MIT
/// \file
/// Counts the elements, loops and groups of a cage that has been checked.
#pragma once

#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// The counts of the surface of a manifold cage: of its faces that are not holes, and what these use. The first
/// vertices of boundary loops are reported zero-based. Repairs and notes stay empty.
CageReport count(const Cage& cage);

}  // namespace umbilic
