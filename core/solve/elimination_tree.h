// SPDX-License-Identifier: MIT
/// \file
/// The order in which the unknowns of a sparse symmetric matrix are eliminated, and which are eliminated together.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace umbilic {

/// Unknowns that are eliminated together as the columns of one dense panel, with the rows below them that this changes.
/// Both are given by their positions in the order of elimination.
struct Supernode {
  int first, width;            ///< the columns [first, first + width)
  std::vector<int> rows;       ///< sorted: the rows below the columns, all >= first + width
  std::vector<int> in_parent;  ///< index of each row among the parent's columns and rows
  std::vector<int> children;   ///< indices of supernodes, all before this one
  std::size_t panel;           ///< offset of its values, (width + rows) x width, column-major

  int below() const { return static_cast<int>(rows.size()); }
  int height() const { return width + below(); }
  /// Multiplications and additions that its elimination takes.
  double flops() const;
};

/// The symbolic half of a multifrontal factorization (Liu, The multifrontal method for sparse matrix solution, SIAM
/// Review 34, 1992).
///
/// Consecutive unknowns with the same neighbours form a group. Groups are ordered by approximate minimum degree.
/// Supernodes are merged with their parents where this stores few zeros.
class EliminationTree {
 public:
  EliminationTree() = default;
  /// From the pattern of a lower triangle; entries above the diagonal are ignored.
  explicit EliminationTree(const Eigen::SparseMatrix<double>& lower);

  /// All supernodes, children before parents.
  const std::vector<Supernode>& supernodes() const { return supernodes_; }
  /// The position of each unknown in the order of elimination.
  const std::vector<int>& positions() const { return positions_; }
  /// Number of values in all panels.
  std::size_t panel_size() const { return panel_size_; }

  /// The matrix's entry number `source` goes to this offset in the panel of its supernode.
  struct Entry {
    int source;
    int target;
  };
  /// The entries of each supernode, in the order of their targets.
  const std::vector<std::vector<Entry>>& entries() const { return entries_; }

 private:
  void locate_entries(const Eigen::SparseMatrix<double>& lower);

  std::vector<Supernode> supernodes_;
  std::vector<int> positions_;
  std::vector<std::vector<Entry>> entries_;
  std::size_t panel_size_ = 0;
};

}  // namespace umbilic
