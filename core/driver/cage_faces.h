// SPDX-License-Identifier: MIT
/// \file
/// Which face of a cage a face of a refined mesh descends from.
#pragma once

#include <vector>

#include "cage/cage.h"
#include "mesh/polygon_mesh.h"

namespace umbilic {

class CageFaces {
 public:
  /// Of a cage and its mesh.
  CageFaces(const Cage& cage, const PolygonMesh& mesh);

  /// The number in the cage of a face of the surface, from which holes are left out.
  int operator[](int face) const { return numbers_[face]; }

  /// Of each of the `count` faces of the surface at a level: the number in the cage of the face that it descends from.
  std::vector<int> at_level(int level, int count) const;

 private:
  std::vector<int> numbers_;
  std::vector<int> of_corners_;  // of each half-edge of the surface: its face's number
};

}  // namespace umbilic
