// SPDX-License-Identifier: MIT
/// \file
/// In which order the unknowns of a sparse symmetric matrix are eliminated, and which of them together.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace umbilic {

/// Unknowns that are eliminated together as the columns of one dense panel, and the unknowns coupled by it. All are
/// given by their positions in the order of elimination.
struct Supernode {
  int first, width;            ///< the columns [first, first + width)
  std::vector<int> rows;       ///< rising: what the elimination changes, all >= first + width
  std::vector<int> in_parent;  ///< of each row, its place in (columns, rows) of the parent
  std::vector<int> children;   ///< supernodes before this one
  std::size_t panel;           ///< where its values begin, (width + rows) x width, column-major

  int below() const { return static_cast<int>(rows.size()); }
  int height() const { return width + below(); }
  /// Multiplications and additions of its elimination.
  double flops() const;
};

/// The symbolic half of a multifrontal factorization (Liu, The multifrontal method for sparse matrix solution, SIAM
/// Review 34, 1992). Consecutive unknowns with the same neighbours are ordered as one, by approximate minimum degree;
/// supernodes are merged with their parents where that stores few zeros.
class EliminationTree {
 public:
  EliminationTree() = default;
  /// Of the pattern of a lower triangle; entries above the diagonal are ignored.
  explicit EliminationTree(const Eigen::SparseMatrix<double>& lower);

  /// Children before parents.
  const std::vector<Supernode>& supernodes() const { return supernodes_; }
  /// Of each unknown, its position in the order of elimination.
  const std::vector<int>& positions() const { return positions_; }
  /// Numbers in all panels.
  std::size_t panel_size() const { return panel_size_; }

  /// Where the matrix's entry `source` goes in the panel of its supernode.
  struct Entry {
    int source;
    int target;
  };
  /// Of each supernode.
  const std::vector<std::vector<Entry>>& entries() const { return entries_; }

 private:
  void place(const Eigen::SparseMatrix<double>& lower);

  std::vector<Supernode> supernodes_;
  std::vector<int> positions_;
  std::vector<std::vector<Entry>> entries_;
  std::size_t panel_size_ = 0;
};

}  // namespace umbilic
