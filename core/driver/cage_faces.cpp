// SPDX-License-Identifier: MIT
/// \file
/// Faces as Catmull-Clark steps number them.
#include "driver/cage_faces.h"

#include <algorithm>

namespace umbilic {

CageFaces::CageFaces(const Cage& cage, const PolygonMesh& mesh) {
  for (int f = 0; f < static_cast<int>(cage.faces.size()); ++f) {
    if (!std::binary_search(cage.holes.begin(), cage.holes.end(), f)) numbers_.push_back(f);
  }
  for (int h = 0; h < mesh.surface_halfedge_count(); ++h) of_corners_.push_back(numbers_[mesh.face(h)]);
}

/// A Catmull-Clark step makes a quad of each half-edge, with the half-edge's number; half-edges of quads are numbered
/// by fours.
std::vector<int> CageFaces::at_level(int level, int count) const {
  std::vector<int> faces(count);
  for (int f = 0; f < count; ++f) faces[f] = level == 0 ? numbers_[f] : of_corners_[f >> 2 * (level - 1)];
  return faces;
}

}  // namespace umbilic
