// SPDX-License-Identifier: MIT
/// \file
/// Partition of the elements of a mesh into orbits of its symmetry group.
#pragma once

#include <vector>

namespace umbilic {

/// Orbits are numbered in the order of their first elements.
struct Orbits {
  std::vector<int> of;     ///< the orbit of each element
  std::vector<int> sizes;  ///< the number of elements of each orbit
};

}  // namespace umbilic
