// SPDX-License-Identifier: MIT
/// \file
/// Vertices of the uniform polyhedra whose edges become frames.
#pragma once

#include <string_view>
#include <vector>

#include "base/types.h"

namespace umbilic {

struct Polyhedron {
  std::string_view name;   ///< name of its frame, "cube-frame"
  std::string_view solid;  ///< name with the article, "a cube"
  int vertices;
  int edges;
  std::vector<Vector3> (*make)();
};

/// Sorted by the genus of the frames, edges - vertices + 1.
const std::vector<Polyhedron>& polyhedra();

}  // namespace umbilic
