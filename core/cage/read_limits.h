// SPDX-License-Identifier: MIT
/// \file
/// How much of a file is read before it is refused.
#pragma once

#include <cstddef>

namespace umbilic {

/// Files come from strangers, and a run cannot use larger ones: its meshes have at most 2 million faces.
struct ReadLimits {
  std::size_t bytes = std::size_t{1} << 28;  ///< of the text; below 2^31, because lines are counted in an int
  int vertices = 4'000'000;
  int faces = 4'000'000;
  int face_size = 10'000;        ///< vertices of one face
  int groups = 10'000;           ///< names of groups, with or without faces
  int memberships = 16'000'000;  ///< faces of all groups together
  std::size_t group_name = 256;  ///< bytes of one name
};

}  // namespace umbilic
