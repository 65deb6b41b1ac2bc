// SPDX-License-Identifier: MIT
/// \file
/// Adjacency of an unchecked polygon mesh.
#include "cage/edges.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <tuple>

namespace umbilic {

namespace {

/// Disjoint sets over 0 … n−1.
class Partition {
 public:
  explicit Partition(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  void join(int i, int j) { parent(root(i)) = root(j); }

 private:
  int& parent(int i) { return parent_[i]; }
  std::vector<int> parent_;
};

/// Index of the first corner of each face, if the corners of all faces are numbered consecutively; the last entry is
/// their number.
std::vector<int> corner_offsets(const Cage& cage) {
  std::vector<int> offsets{0};
  offsets.reserve(cage.faces.size() + 1);
  for (const std::vector<int>& face : cage.faces) offsets.push_back(offsets.back() + static_cast<int>(face.size()));
  return offsets;
}

}  // namespace

std::vector<EdgeUse> edge_uses(const Cage& cage) {
  std::vector<EdgeUse> uses;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int>& face = cage.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i];
      const int to = face[(i + 1) % face.size()];
      uses.push_back({std::min(from, to), std::max(from, to), static_cast<int>(f), static_cast<int>(i), from < to});
    }
  }
  const auto key = [](const EdgeUse& use) { return std::tuple(use.low, use.high, use.face, use.corner); };
  std::sort(uses.begin(), uses.end(), [&](const EdgeUse& a, const EdgeUse& b) { return key(a) < key(b); });
  return uses;
}

std::vector<int> opposite_uses(const std::vector<EdgeUse>& uses) {
  std::vector<int> opposite(uses.size(), -1);
  for (std::size_t i = 0; i + 1 < uses.size(); ++i) {
    if (!same_edge(uses[i], uses[i + 1])) continue;
    assert(opposite[i] < 0);
    opposite[i] = static_cast<int>(i + 1);
    opposite[i + 1] = static_cast<int>(i);
  }
  return opposite;
}

std::vector<EdgeUse> open_uses(const std::vector<EdgeUse>& uses) {
  const std::vector<int> opposite = opposite_uses(uses);
  std::vector<EdgeUse> open;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (opposite[i] < 0) open.push_back(uses[i]);
  }
  return open;
}

Orientation orient(const Cage& cage, const std::vector<EdgeUse>& uses) {
  const std::vector<int> opposite = opposite_uses(uses);
  const std::vector<int> offsets = corner_offsets(cage);
  const auto side = [&](const EdgeUse& use) { return offsets[use.face] + use.corner; };
  std::vector<int> use_of_side(uses.size());
  for (std::size_t i = 0; i < uses.size(); ++i) use_of_side[side(uses[i])] = static_cast<int>(i);

  Orientation result;
  result.component.assign(cage.faces.size(), -1);
  result.flipped.assign(cage.faces.size(), false);
  std::vector<std::size_t> pending;
  for (std::size_t seed = 0; seed < cage.faces.size(); ++seed) {
    if (result.component[seed] >= 0) continue;
    result.component[seed] = result.component_count++;
    pending.assign(1, seed);
    while (!pending.empty()) {
      const std::size_t face = pending.back();
      pending.pop_back();
      for (int s = offsets[face]; s < offsets[face + 1]; ++s) {
        const int here = use_of_side[s];
        if (opposite[here] < 0) continue;
        const EdgeUse& across = uses[opposite[here]];
        const int other = across.face;
        const bool flip = result.flipped[face] != (uses[here].forward == across.forward);
        if (result.component[other] < 0) {
          result.component[other] = result.component[face];
          result.flipped[other] = flip;
          pending.push_back(other);
        } else if (result.flipped[other] != flip) {
          result.conflict = across.face;
          return result;
        }
      }
    }
  }
  return result;
}

std::vector<int> fan_counts(const Cage& cage, const std::vector<EdgeUse>& uses) {
  const std::vector<int> offsets = corner_offsets(cage);
  const auto corner_at = [&](const EdgeUse& use, bool low) {
    const int size = offsets[use.face + 1] - offsets[use.face];
    return offsets[use.face] + (use.corner + (low == use.forward ? 0 : 1)) % size;
  };
  Partition fans(offsets.back());
  const std::vector<int> opposite = opposite_uses(uses);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (opposite[i] < static_cast<int>(i)) continue;
    for (const bool low : {true, false}) fans.join(corner_at(uses[i], low), corner_at(uses[opposite[i]], low));
  }
  std::vector<int> counts(cage.vertices.rows(), 0);
  int corner = 0;
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) {
      if (fans.root(corner) == corner) ++counts[v];
      ++corner;
    }
  }
  return counts;
}

}  // namespace umbilic
