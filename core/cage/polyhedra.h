// SPDX-License-Identifier: MIT
/// \file
/// Vertices of the uniform polyhedra that frames are drawn on.
#pragma once

#include <string_view>
#include <vector>

#include "base/types.h"

namespace umbilic {

struct Polyhedron {
  std::string_view name;   ///< of its frame, "cube-frame"
  std::string_view solid;  ///< with the article, "a cube"
  int vertices;
  int edges;
  std::vector<Vector3> (*make)();
};

/// In the order of the frames' genus, edges − vertices + 1.
const std::vector<Polyhedron>& polyhedra();

}  // namespace umbilic
