// SPDX-License-Identifier: MIT
/// \file
/// Solves with the factors of a sparse matrix.
///
/// Threads substitute in subtrees at the same time. What these subtract from rows at the top of the tree waits until
/// its turn comes, so that each row's terms are subtracted in the order of the supernodes.
#include <algorithm>

#include "solve/sparse_cholesky.h"

namespace umbilic {

/// Eliminates the node's columns from its first `rows` rows; `rest` receives what is to be subtracted from the others.
template <class Right>
void SparseCholesky::eliminate_right(const Supernode& node, int rows, Right& right, Right& rest) const {
  const Eigen::Map<const Eigen::MatrixXd> panel(panels_.data() + node.panel, node.height(), node.width);
  auto own = right.middleRows(node.first, node.width);
  panel.topRows(node.width).template triangularView<Eigen::UnitLower>().solveInPlace(own);
  rest.noalias() = panel.bottomRows(node.below()) * own;
  for (int i = 0; i < rows; ++i) right.row(node.rows[i]) -= rest.row(i);
}

template <class Right>
void SparseCholesky::substitute_back(const Supernode& node, Right& right, Right& coupled) const {
  const Eigen::Map<const Eigen::MatrixXd> panel(panels_.data() + node.panel, node.height(), node.width);
  auto own = right.middleRows(node.first, node.width);
  coupled.resize(node.below(), right.cols());
  for (int i = 0; i < node.below(); ++i) coupled.row(i) = right.row(node.rows[i]);
  own.noalias() -= panel.bottomRows(node.below()).transpose() * coupled;
  panel.topRows(node.width).transpose().template triangularView<Eigen::UnitUpper>().solveInPlace(own);
}

template <class Right>
void SparseCholesky::solve_in_place(Right& right) const {
  const std::vector<Supernode>& nodes = tree_.supernodes();
  const int subtrees = static_cast<int>(split_.subtrees.size());
  std::vector<Right> waiting(subtrees);  // what each subtree's supernodes, one after the other, subtract outside it
  const auto forward = [&](int subtree) {
    Right rest;
    int total = 0, end = 0;
    for (const int s : split_.subtrees[subtree]) total += nodes[s].below() - split_.inner_rows[s];
    waiting[subtree].resize(total, right.cols());
    for (const int s : split_.subtrees[subtree]) {
      const int inner = split_.inner_rows[s], outer = nodes[s].below() - inner;
      eliminate_right(nodes[s], inner, right, rest);
      waiting[subtree].middleRows(end, outer) = rest.bottomRows(outer);
      end += outer;
    }
  };
  const auto at_top = [&] {
    Right rest;
    std::vector<int> next(subtrees, 0);
    for (std::size_t s = 0; s < nodes.size(); ++s) {
      const Supernode& node = nodes[s];
      const int subtree = split_.subtree_of[s];
      if (subtree < 0) {
        eliminate_right(node, node.below(), right, rest);
        continue;
      }
      for (int i = split_.inner_rows[s]; i < node.below(); ++i) {
        right.row(node.rows[i]) -= waiting[subtree].row(next[subtree]++);
      }
    }
    right.array().colwise() /= pivot_.array();
    for (auto s = split_.top.rbegin(); s != split_.top.rend(); ++s) substitute_back(nodes[*s], right, rest);
  };
  if (subtrees == 0) return at_top();
  const int pieces[] = {subtrees, 1, subtrees};
  in_stages(pieces, [&](int stage, int piece, int) {
    if (stage == 0) return forward(piece);
    if (stage == 1) return at_top();
    Right coupled;
    const std::vector<int>& subtree = split_.subtrees[piece];
    for (auto s = subtree.rbegin(); s != subtree.rend(); ++s) substitute_back(nodes[*s], right, coupled);
  });
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd result(right.size());
  for (Eigen::Index j = 0; j < right.size(); ++j) result[tree_.positions()[j]] = right[j];
  solve_in_place(result);
  return result(tree_.positions());
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  RowMajor result(right.rows(), right.cols());
  for (Eigen::Index j = 0; j < right.rows(); ++j) result.row(tree_.positions()[j]) = right.row(j);
  solve_in_place(result);
  return result(tree_.positions(), Eigen::all);
}

}  // namespace umbilic
