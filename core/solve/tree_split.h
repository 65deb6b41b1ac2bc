// SPDX-License-Identifier: MIT
/// \file
/// How several threads share an elimination tree: subtrees that depend on nothing outside them, for one thread each,
/// and the top of the tree, whose supernodes come one after the other when all subtrees are done.
#pragma once

#include <vector>

#include "solve/elimination_tree.h"

namespace umbilic {

struct TreeSplit {
  /// Whether there is so much work that it is shared.
  bool shared = false;
  /// The supernodes of each subtree, children before parents; first the subtree with the most work.
  std::vector<std::vector<int>> subtrees;
  /// All others, children before parents.
  std::vector<int> top;
  /// Of each supernode: how many of its rows are columns of its own subtree; they come first. All rows in the top.
  std::vector<int> inner_rows;
  /// Of each supernode: its subtree, -1 at the top.
  std::vector<int> subtree_of;

  TreeSplit() = default;
  /// Subtrees of so little work each that `threads` have about the same. With one thread all supernodes are the top.
  TreeSplit(const EliminationTree& tree, int threads);
};

}  // namespace umbilic
