// SPDX-License-Identifier: MIT
/// \file
/// Which elements of a mesh are images of one another.
#pragma once

#include <vector>

namespace umbilic {

/// A partition into orbits, numbered by their first elements.
struct Orbits {
  std::vector<int> of;     ///< of each element: its orbit
  std::vector<int> sizes;  ///< of each orbit: its elements
};

}  // namespace umbilic
