// SPDX-License-Identifier: MIT
/// \file
/// Chains the open sides of the faces.
#include "cage/boundary.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace umbilic {

std::vector<std::vector<int>> boundary_loops(const Cage& cage) {
  return boundary_loops(cage, open_uses(edge_uses(cage)));
}

std::vector<std::vector<int>> boundary_loops(const Cage& cage, const std::vector<EdgeUse>& open) {
  std::vector<std::pair<int, int>> sides;  // from, to: as the face goes
  for (const EdgeUse& use : open) {
    const std::vector<int>& face = cage.faces[use.face];
    const auto low = std::find(face.begin(), face.end(), use.low);
    const bool forward = (low + 1 == face.end() ? face.front() : low[1]) == use.high;
    sides.push_back(forward ? std::pair(use.low, use.high) : std::pair(use.high, use.low));
  }
  std::sort(sides.begin(), sides.end());
  std::vector<bool> seen(sides.size(), false);
  std::vector<std::vector<int>> loops;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    if (seen[first]) continue;
    std::vector<int>& loop = loops.emplace_back();
    for (std::size_t side = first; !seen[side];) {
      seen[side] = true;
      loop.push_back(sides[side].first);
      const auto next = std::lower_bound(sides.begin(), sides.end(), std::pair(sides[side].second, -1));
      assert(next != sides.end() && next->first == sides[side].second);
      side = static_cast<std::size_t>(next - sides.begin());
    }
  }
  return loops;
}

Cage without_holes(const Cage& cage) {
  Cage surface{cage.vertices};
  for (int f = 0; f < static_cast<int>(cage.faces.size()); ++f) {
    if (!std::binary_search(cage.holes.begin(), cage.holes.end(), f)) surface.faces.push_back(cage.faces[f]);
  }
  return surface;
}

std::vector<std::vector<int>> surface_boundaries(const Cage& cage) { return boundary_loops(without_holes(cage)); }

}  // namespace umbilic
