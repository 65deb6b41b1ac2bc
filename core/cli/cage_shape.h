// SPDX-License-Identifier: MIT
/// \file
/// What can be said about a cage's connectivity without evaluating its surface.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cage/cage.h"

namespace umbilic::cli {

struct CageShape {
  std::map<int, int> valences;     ///< number of edges at a vertex -> number of such vertices
  std::map<int, int> face_sizes;   ///< edges -> number of faces
  std::optional<int> first_level;  ///< the first level that can be evaluated
  std::string obstacle;            ///< why no level can be evaluated
};

/// `cage` must have passed `validate`. Its holes, and what only these use, are not counted.
CageShape shape_of(const Cage& cage);

}  // namespace umbilic::cli
