// SPDX-License-Identifier: MIT
/// \file
/// Control points whose limit surface passes through given points.
#pragma once

#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// Moves the vertices `free` of a cage of quads, each with all its faces around it, until the limit surface has
/// `targets` at them (one row for each vertex of the cage; the rows of other vertices do not count). The limit at a
/// vertex v of valence n is (n² v + 4 Σ edge neighbours + Σ opposite corners) / (n (n + 5)). Each step moves a vertex
/// by 1.5 times what its limit lacks; on a regular net the error shrinks to 5/6 at least, so that round-off is reached.
void fit_limit(Cage& cage, const std::vector<int>& free, const Points& targets);

}  // namespace umbilic
