// SPDX-License-Identifier: MIT
/// \file
/// A finite group that acts freely on flags: its elements, and isometries that satisfy its relations to rounding.
#pragma once

#include <vector>

#include "mesh/flag_matching.h"

namespace umbilic {

/// All elements of a group. Element i maps the base flag to flags[i]; element 0 is the identity. For i > 0, element i
/// is generator by[i] times element from[i], with from[i] < i.
struct Elements {
  std::vector<Flag> flags;
  std::vector<int> by, from;
  std::vector<std::vector<int>> left;  ///< generator g times element i is element left[g][i]

  int count() const { return static_cast<int>(flags.size()); }
};

/// All elements of the group that `generators` generate, found as the orbit of the flag `base`.
Elements elements(const std::vector<Symmetry>& generators, Flag base, int halfedge_count);

/// The isometry of each element, a product of the generators' isometries.
std::vector<Eigen::Matrix3d> isometries(const Elements& elements, const std::vector<Symmetry>& generators);

/// Makes the generators' isometries satisfy the relations of the group to rounding, so that the product for an element
/// no longer depends on how it is written in generators. Each R_g is replaced by the orthogonal matrix nearest to the
/// mean of R_{gh} R_h^T over all elements h, until R_{gh} = R_g R_h for all generators g. The error squares in each
/// step (Grove, Karcher & Ruh 1974). Returns false if it does not vanish. Exact generators are left unchanged.
bool make_exact(const Elements& elements, std::vector<Symmetry>& generators);

}  // namespace umbilic
