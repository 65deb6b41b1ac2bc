// SPDX-License-Identifier: MIT
/// \file
/// Eliminates supernodes by dense blocks, children before parents.
#include "solve/sparse_cholesky.h"

#include <algorithm>
#include <cmath>

namespace umbilic {
namespace {

/// Floating-point operations per call of `advance`.
constexpr double kFlopsPerPart = 1e8;
/// Columns of a panel that are eliminated one by one before all later columns are updated at once.
constexpr int kBlock = 16;

bool same_pattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
  return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace

void SparseCholesky::begin(Matrix lower) {
  lower.makeCompressed();
  if (!same_pattern(lower, lower_)) {
    tree_ = EliminationTree(lower);
    panels_.resize(tree_.panel_size());
    flops_ = 0;
    for (const Supernode& node : tree_.supernodes()) flops_ += node.flops();
  }
  lower_ = std::move(lower);
  pivot_.setZero(lower_.cols());
  updates_.assign(tree_.supernodes().size(), {});
  next_ = 0;
  flops_done_ = 0;
  stage_ = Stage::kFactoring;
}

bool SparseCholesky::advance() {
  const int count = static_cast<int>(tree_.supernodes().size());
  const double until = flops_done_ + kFlopsPerPart;
  while (stage_ == Stage::kFactoring && next_ < count && flops_done_ < until) {
    if (!eliminate(next_)) stage_ = Stage::kFailed;
    flops_done_ += tree_.supernodes()[next_++].flops();
  }
  if (stage_ == Stage::kFactoring && next_ == count) stage_ = Stage::kFactored;
  if (stage_ == Stage::kFailed) updates_.clear();
  return stage_ != Stage::kFactoring;
}

double SparseCholesky::progress() const { return stage_ == Stage::kFactoring && flops_ > 0 ? flops_done_ / flops_ : 1; }

bool SparseCholesky::factor(Matrix lower) {
  begin(std::move(lower));
  while (!advance()) {
  }
  return succeeded();
}

/// Sums the matrix's own entries and the updates of the children.
void SparseCholesky::assemble(const Supernode& node, double* panel, Eigen::MatrixXd& update) {
  std::fill_n(panel, static_cast<std::size_t>(node.height()) * node.width, 0.0);
  for (const auto [source, target] : tree_.entries()[&node - tree_.supernodes().data()]) {
    panel[target] += lower_.valuePtr()[source];
  }
  update.setZero(node.below(), node.below());
  for (int child : node.children) {
    const std::vector<int>& place = tree_.supernodes()[child].in_parent;
    const int size = static_cast<int>(place.size());
    for (int c = 0; c < size; ++c) {
      const double* from = updates_[child].col(c).data();
      const bool own = place[c] < node.width;
      double* to =
          own ? panel + static_cast<std::size_t>(place[c]) * node.height() : update.col(place[c] - node.width).data();
      const int shift = own ? 0 : node.width;
      for (int r = c; r < size; ++r) to[place[r] - shift] += from[r];
    }
    updates_[child].resize(0, 0);
  }
}

/// Turns the columns [first, first + count) into those of L. Later columns are not changed.
bool SparseCholesky::eliminate_columns(Panel panel, int first, int count, Eigen::Ref<Eigen::VectorXd> pivot) const {
  const Eigen::Index height = panel.rows();
  for (int j = first; j < first + count; ++j) {
    const double d = panel(j, j);
    if (!std::isfinite(d) || (pivots_ == Pivots::kPositive ? d <= 0 : d == 0)) return false;
    pivot[j] = d;
    for (int k = j + 1; k < first + count; ++k) {
      panel.col(k).tail(height - k) -= (panel(k, j) / d) * panel.col(j).tail(height - k);
    }
    panel.col(j).tail(height - j - 1) /= d;
  }
  return true;
}

bool SparseCholesky::eliminate(int supernode) {
  const Supernode& node = tree_.supernodes()[supernode];
  const int width = node.width, height = node.height(), below = node.below();
  double* values = panels_.data() + node.panel;
  Eigen::MatrixXd& update = updates_[supernode];
  assemble(node, values, update);

  Panel panel(values, height, width);
  auto pivot = pivot_.segment(node.first, width);
  for (int first = 0; first < width; first += kBlock) {
    const int count = std::min(kBlock, width - first), next = first + count;
    if (!eliminate_columns(panel, first, count, pivot)) return false;
    if (next == width) break;
    const auto done = panel.block(next, first, height - next, count);
    const Eigen::MatrixXd scaled = done.topRows(width - next) * pivot.segment(first, count).asDiagonal();
    panel.block(next, next, width - next, width - next).triangularView<Eigen::Lower>() -=
        done.topRows(width - next) * scaled.transpose();
    panel.block(width, next, below, width - next).noalias() -= done.bottomRows(below) * scaled.transpose();
  }
  if (below > 0) {
    const auto coupling = panel.bottomRows(below);
    const Eigen::MatrixXd scaled = coupling * pivot.asDiagonal();
    update.triangularView<Eigen::Lower>() -= coupling * scaled.transpose();
  }
  return true;
}

template <class Right>
void SparseCholesky::solve_in_place(Right& right) const {
  const std::vector<Supernode>& nodes = tree_.supernodes();
  using Factor = Eigen::Map<const Eigen::MatrixXd>;
  Right coupled;
  for (const Supernode& node : nodes) {
    const Factor panel(panels_.data() + node.panel, node.height(), node.width);
    auto own = right.middleRows(node.first, node.width);
    panel.topRows(node.width).template triangularView<Eigen::UnitLower>().solveInPlace(own);
    coupled.noalias() = panel.bottomRows(node.below()) * own;
    for (int i = 0; i < node.below(); ++i) right.row(node.rows[i]) -= coupled.row(i);
  }
  right.array().colwise() /= pivot_.array();
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    const Factor panel(panels_.data() + node->panel, node->height(), node->width);
    auto own = right.middleRows(node->first, node->width);
    coupled.resize(node->below(), right.cols());
    for (int i = 0; i < node->below(); ++i) coupled.row(i) = right.row(node->rows[i]);
    own.noalias() -= panel.bottomRows(node->below()).transpose() * coupled;
    panel.topRows(node->width).transpose().template triangularView<Eigen::UnitUpper>().solveInPlace(own);
  }
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
