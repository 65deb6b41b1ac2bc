// SPDX-License-Identifier: MIT
/// \file
/// Which elements of a mesh are images of one another.
#pragma once

#include <vector>

namespace umbilic {

/// A partition of the elements 0, 1, … into orbits 0, 1, ….
struct Orbits {
  std::vector<int> of;     ///< of each element: its orbit
  std::vector<int> sizes;  ///< of each orbit: its elements
};

}  // namespace umbilic
