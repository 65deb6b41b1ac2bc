// SPDX-License-Identifier: MIT
/// \file
/// A finite group that acts freely on flags: its elements, and isometries that satisfy its relations to rounding.
#pragma once

#include <vector>

#include "mesh/flag_matching.h"

namespace umbilic {

/// Element i maps a base flag to flags[i]; element 0 is the identity. Element i > 0 is the product of generator
/// by[i] and element from[i] < i.
struct Elements {
  std::vector<Flag> flags;
  std::vector<int> by, from;
  std::vector<std::vector<int>> left;  ///< generator g times element i is element left[g][i]

  int count() const { return static_cast<int>(flags.size()); }
};

/// The orbit of `base`.
Elements elements(const std::vector<Symmetry>& generators, Flag base, int halfedge_count);

/// The isometries of all elements, as words in those of the generators.
std::vector<Eigen::Matrix3d> isometries(const Elements& elements, const std::vector<Symmetry>& generators);

/// Replaces each R_g by the orthogonal matrix nearest to the mean of R_{gh} R_h^T over all elements h, until R_{gh} =
/// R_g R_h to rounding for all generators g: products of noisy isometries then depend only on the element. The error
/// squares with each step (Grove, Karcher & Ruh 1974). False where it does not vanish. Generators that are exact remain
/// as they are.
bool make_exact(const Elements& elements, std::vector<Symmetry>& generators);

}  // namespace umbilic
