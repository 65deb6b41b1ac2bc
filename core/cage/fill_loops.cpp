// SPDX-License-Identifier: MIT
/// \file
/// Follows the sides that have no face on the other side.
#include "cage/fill_loops.h"

#include <algorithm>
#include <utility>

#include "cage/edges.h"

namespace umbilic {

std::vector<std::vector<int>> loops_to_fill(const Cage& cage) {
  const auto is_hole = [&](int face) { return std::binary_search(cage.holes.begin(), cage.holes.end(), face); };
  const std::vector<EdgeUse> uses = edge_uses(cage);
  std::vector<int> next(cage.vertices.rows(), -1);
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i;
    const EdgeUse* only = nullptr;
    int count = 0;
    for (; end < uses.size() && same_edge(uses[i], uses[end]); ++end) {
      if (is_hole(uses[end].face)) continue;
      only = &uses[end];
      ++count;
    }
    if (count == 1) next[only->forward ? only->low : only->high] = only->forward ? only->high : only->low;
    i = end;
  }
  std::vector<std::vector<int>> loops;
  for (int first = 0; first < static_cast<int>(next.size()); ++first) {
    if (next[first] < 0) continue;
    loops.emplace_back();
    for (int v = first; next[v] >= 0;) {
      loops.back().push_back(v);
      v = std::exchange(next[v], -1);
    }
  }
  return loops;
}

}  // namespace umbilic
