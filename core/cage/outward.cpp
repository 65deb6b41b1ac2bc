// SPDX-License-Identifier: MIT
/// \file
/// Orientation by enclosed volume, or by the majority of the faces.
#include "cage/outward.h"

#include <algorithm>

namespace umbilic {

TurnedFaces turn_outward(Cage& cage, const Orientation& orientation, const std::vector<ComponentSize>& sizes,
                         const std::vector<bool>& is_open) {
  std::vector<int> faces(sizes.size(), 0), flipped(sizes.size(), 0);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    ++faces[orientation.component[f]];
    flipped[orientation.component[f]] += orientation.flipped[f] ? 1 : 0;
  }
  TurnedFaces turned;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const int c = orientation.component[f];
    const bool most_are_flipped = 2 * flipped[c] > faces[c];
    const bool inward = is_open[c] || sizes[c].is_without_volume() ? most_are_flipped : sizes[c].volume < 0;
    if (orientation.flipped[f] == inward) continue;
    std::reverse(cage.faces[f].begin() + 1, cage.faces[f].end());
    ++(flipped[c] == 0 ? turned.inward : turned.disagreed);
  }
  return turned;
}

}  // namespace umbilic
