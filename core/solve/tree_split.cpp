// SPDX-License-Identifier: MIT
/// \file
/// Takes the roots of the largest subtrees away until the rest is small enough.
#include "solve/tree_split.h"

#include <algorithm>

#include "base/threads.h"

namespace umbilic {
namespace {

/// A subtree is at most this part of what each thread would have to do if all did the same.
constexpr double kLargestPart = 0.25;
/// What takes fewer floating-point operations is not shared: waking a thread takes longer.
constexpr double kLeastShared = 5e6;

/// The supernodes of a subtree, in rising order.
std::vector<int> descendants(int root, const std::vector<Supernode>& nodes) {
  std::vector<int> members{root};
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::vector<int>& children = nodes[members[i]].children;
    members.insert(members.end(), children.begin(), children.end());
  }
  std::sort(members.begin(), members.end());
  return members;
}

}  // namespace

TreeSplit::TreeSplit(const EliminationTree& tree, int threads) {
  const std::vector<Supernode>& nodes = tree.supernodes();
  std::vector<double> work;  // of each subtree, by its root
  std::vector<bool> has_parent(nodes.size(), false);
  double all = 0;
  for (const Supernode& node : nodes) {
    work.push_back(node.flops());
    all += node.flops();
    for (const int child : node.children) {
      work.back() += work[child];
      has_parent[child] = true;
    }
  }
  std::vector<int> roots;
  const auto less = [&](int a, int b) { return work[a] != work[b] ? work[a] < work[b] : a > b; };
  shared = threads > 1 && all >= kLeastShared;
  if (shared) {
    for (std::size_t s = 0; s < nodes.size(); ++s) {
      if (!has_parent[s]) roots.push_back(static_cast<int>(s));
    }
    std::make_heap(roots.begin(), roots.end(), less);
    while (!roots.empty() && work[roots.front()] > kLargestPart * all / threads) {
      std::pop_heap(roots.begin(), roots.end(), less);
      const int root = roots.back();
      roots.pop_back();
      for (const int child : nodes[root].children) {
        roots.push_back(child);
        std::push_heap(roots.begin(), roots.end(), less);
      }
    }
    std::sort(roots.begin(), roots.end(), [&](int a, int b) { return less(b, a); });
  }

  subtree_of.assign(nodes.size(), -1);
  inner_rows.resize(nodes.size());
  for (std::size_t s = 0; s < nodes.size(); ++s) inner_rows[s] = nodes[s].below();
  for (const int root : roots) {
    const int number = static_cast<int>(subtrees.size());
    subtrees.push_back(descendants(root, nodes));
    const int end = nodes[root].first + nodes[root].width;
    for (const int s : subtrees.back()) {
      const std::vector<int>& rows = nodes[s].rows;
      inner_rows[s] = static_cast<int>(std::lower_bound(rows.begin(), rows.end(), end) - rows.begin());
      subtree_of[s] = number;
    }
  }
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    if (subtree_of[s] < 0) top.push_back(static_cast<int>(s));
  }
}

}  // namespace umbilic
