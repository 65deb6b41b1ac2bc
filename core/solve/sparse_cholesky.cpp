// SPDX-License-Identifier: MIT
/// \file
/// Eliminates supernodes by dense blocks, children before parents.
#include "solve/sparse_cholesky.h"

#include <algorithm>

#include "solve/solve_kernels.h"

namespace umbilic {
namespace {

/// Floating-point operations per call of `advance`.
constexpr double kFlopsPerPart = 1e8;

bool same_pattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
  return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

/// Rows of a child that lie side by side in its parent as well.
struct Run {
  int begin, end;
};

std::vector<Run> runs_of(const std::vector<int>& place) {
  std::vector<Run> runs;
  const int size = static_cast<int>(place.size());
  for (int r = 0; r < size; ++r) {
    if (r == 0 || place[r] != place[r - 1] + 1) runs.push_back({r, r});
    runs.back().end = r + 1;
  }
  return runs;
}

void add_rows(const double* from, int begin, int end, double* to, int place) {
  for (int r = begin; r < end; ++r) to[place + r - begin] += from[r];
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
  for (AlignedDoubles& update : updates_) {
    if (!update.empty()) free_.push_back(std::move(update));
  }
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

/// Memory for a matrix of this many values: the smallest that is free and large enough, or else the largest, grown.
AlignedDoubles SparseCholesky::take_memory(std::size_t size) {
  AlignedDoubles result;
  if (!free_.empty()) {
    const auto better = [&](const AlignedDoubles& a, const AlignedDoubles& b) {
      const bool a_fits = a.size() >= size, b_fits = b.size() >= size;
      if (a_fits != b_fits) return a_fits;
      return a_fits ? a.size() < b.size() : a.size() > b.size();
    };
    const auto best = std::min_element(free_.begin(), free_.end(), better);
    std::swap(*best, free_.back());
    result = std::move(free_.back());
    free_.pop_back();
  }
  if (result.size() < size) {
    result = {};  // nothing is copied
    result.resize(size);
  }
  return result;
}

/// Sums the matrix's own entries and the updates of the children.
void SparseCholesky::assemble(const Supernode& node, double* panel, double* update) {
  const auto height = static_cast<std::size_t>(node.height()), below = static_cast<std::size_t>(node.below());
  std::fill_n(panel, height * node.width, 0.0);
  for (const auto [source, target] : tree_.entries()[&node - tree_.supernodes().data()]) {
    panel[target] += lower_.valuePtr()[source];
  }
  for (std::size_t c = 0; c < below; ++c) std::fill_n(update + c * below + c, below - c, 0.0);
  for (int child : node.children) {
    const std::vector<int>& place = tree_.supernodes()[child].in_parent;
    const std::vector<Run> runs = runs_of(place);
    const int size = static_cast<int>(place.size());
    const double* from = updates_[child].data();
    std::size_t run = 0;
    for (int c = 0; c < size; ++c, from += size) {
      const bool own = place[c] < node.width;
      double* to = own ? panel + place[c] * height : update + (place[c] - node.width) * below;
      const int shift = own ? 0 : node.width;
      if (runs[run].end <= c) ++run;
      add_rows(from, c, runs[run].end, to, place[c] - shift);
      for (std::size_t i = run + 1; i < runs.size(); ++i) {
        add_rows(from, runs[i].begin, runs[i].end, to, place[runs[i].begin] - shift);
      }
    }
    free_.push_back(std::move(updates_[child]));
  }
}

bool SparseCholesky::eliminate(int supernode) {
  const Supernode& node = tree_.supernodes()[supernode];
  const DensePanel panel{panels_.data() + node.panel, node.height(), node.width};
  AlignedDoubles& update = updates_[supernode];
  update = take_memory(static_cast<std::size_t>(node.below()) * node.below());
  assemble(node, panel.values, update.data());

  const SolveKernels& kernels = solve_kernels();
  double* pivots = pivot_.data() + node.first;
  double* scratch = reserve(scratch_, kernels.scratch_size(panel.height));
  if (!kernels.eliminate_panel(panel, pivots_ == Pivots::kPositive, pivots, scratch)) return false;
  const DenseFactor below{panel.values + panel.width, panel.height, node.below(), panel.width};
  kernels.subtract_product(below, pivots, update.data(), scratch);
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
