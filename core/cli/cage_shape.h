// SPDX-License-Identifier: MIT
/// \file
/// What there is to say about a cage's connectivity before a surface is made of it.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "cage/cage.h"

namespace umbilic::cli {

struct CageShape {
  std::map<int, int> valences;     ///< valence -> number of vertices
  std::map<int, int> face_sizes;   ///< edges -> number of faces
  std::optional<int> first_level;  ///< the first level that can be evaluated
  std::string obstacle;            ///< why there is none
};

/// `cage` has passed `validate`.
CageShape shape_of(const Cage& cage);

}  // namespace umbilic::cli
