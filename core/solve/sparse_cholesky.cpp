// SPDX-License-Identifier: MIT
/// \file
/// Eliminates supernodes by dense blocks, children before parents. sparse_substitution.cpp solves with the factors.
#include "solve/sparse_cholesky.h"

#include <algorithm>
#include <limits>

namespace umbilic {
namespace {

/// Floating-point operations per call of `advance`; with several threads so many times as much for each.
constexpr double kFlopsPerPart = 1e8;
constexpr int kFactorPartsPerThread = 10;
/// A supernode that takes fewer floating-point operations is left to one thread.
constexpr double kLeastSharedNode = 1e6;
/// Columns of a piece of a supernode: few enough to divide the work evenly, enough for the copies of factors that each
/// piece makes to take little time beside their products.
constexpr int kAssembledColumns = 64, kEliminatedColumns = 3 * kPanelBlock, kProductColumns = 96;

int pieces_of(int columns, int columns_per_piece) { return (columns + columns_per_piece - 1) / columns_per_piece; }

bool same_pattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
  return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

/// Rows of a child that lie side by side in its parent as well.
struct Run {
  int begin, end;
};

/// The runs from row `first` on.
std::vector<Run> runs_of(const std::vector<int>& place, int first) {
  std::vector<Run> runs;
  const int size = static_cast<int>(place.size());
  for (int r = first; r < size; ++r) {
    if (r == first || place[r] != place[r - 1] + 1) runs.push_back({r, r});
    runs.back().end = r + 1;
  }
  return runs;
}

void add_rows(const double* from, int begin, int end, double* to, int place) {
  for (int r = begin; r < end; ++r) to[place + r - begin] += from[r];
}

int index_of(const std::vector<int>& sorted, int least) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), least) - sorted.begin());
}

}  // namespace

void SparseCholesky::begin(Matrix lower) {
  lower.makeCompressed();
  if (!same_pattern(lower, lower_)) {
    tree_ = EliminationTree(lower);
    panels_.resize(tree_.panel_size());
    flops_ = 0;
    for (const Supernode& node : tree_.supernodes()) flops_ += node.flops();
    sharing_ = 0;
  }
  if (sharing_ != thread_count()) {
    sharing_ = thread_count();
    split_ = TreeSplit(tree_, sharing_);
  }
  lower_ = std::move(lower);
  pivot_.setZero(lower_.cols());
  for (AlignedDoubles& update : updates_) shared_->memory.put_back(std::move(update));
  updates_.assign(tree_.supernodes().size(), {});
  subtrees_done_ = split_.subtrees.empty();
  next_ = 0;
  flops_done_ = 0;
  shared_->failed = false;
  stage_ = Stage::kFactoring;
}

bool SparseCholesky::advance() {
  if (stage_ != Stage::kFactoring) return true;
  scratch_.resize(std::max<std::size_t>(scratch_.size(), thread_count()));
  subtrees_done_ ? eliminate_top() : eliminate_subtrees();
  if (shared_->failed) {
    stage_ = Stage::kFailed;
    updates_.clear();
  } else if (subtrees_done_ && next_ == split_.top.size()) {
    stage_ = Stage::kFactored;
  }
  return stage_ != Stage::kFactoring;
}

double SparseCholesky::progress() const { return stage_ == Stage::kFactoring && flops_ > 0 ? flops_done_ / flops_ : 1; }

bool SparseCholesky::factor(Matrix lower) {
  begin(std::move(lower));
  while (!advance()) {
  }
  return succeeded();
}

void SparseCholesky::eliminate_subtrees() {
  parallel_for(static_cast<int>(split_.subtrees.size()), [&](int i, int member) {
    for (const int supernode : split_.subtrees[i]) {
      if (!shared_->failed) eliminate(supernode, scratch_[member]);
    }
  });
  for (const std::vector<int>& subtree : split_.subtrees) {
    for (const int supernode : subtree) flops_done_ += tree_.supernodes()[supernode].flops();
  }
  subtrees_done_ = true;
}

/// How a supernode is eliminated by several threads.
struct SparseCholesky::Step {
  enum class Kind { kWhole, kBegin, kAssemble, kEliminate, kSubtract };
  Kind kind;
  int supernode;
  int blocks_before;  // of panels of supernodes that come earlier
};

/// The steps for several supernodes, one after the other.
struct SparseCholesky::Steps {
  std::vector<Step> steps;
  std::vector<int> pieces;  // of each
  int blocks = 0;

  void add(int supernode, const Supernode& node) {
    const auto step = [&](Step::Kind kind, int count) {
      steps.push_back({kind, supernode, blocks});
      pieces.push_back(count);
    };
    if (node.flops() < kLeastSharedNode) return step(Step::Kind::kWhole, 1);
    step(Step::Kind::kBegin, 1);
    step(Step::Kind::kAssemble, pieces_of(node.height(), kAssembledColumns));
    step(Step::Kind::kEliminate, pieces_of(node.width, kEliminatedColumns));
    step(Step::Kind::kSubtract, pieces_of(node.below(), kProductColumns));
    blocks += pieces_of(node.width, kPanelBlock);
  }
};

void SparseCholesky::eliminate_top() {
  const bool shared = split_.shared;
  const double until = flops_done_ + (shared ? kFactorPartsPerThread * sharing_ : 1) * kFlopsPerPart;
  Steps steps;
  for (; next_ < split_.top.size() && flops_done_ < until && !shared_->failed; ++next_) {
    const int supernode = split_.top[next_];
    const Supernode& node = tree_.supernodes()[supernode];
    flops_done_ += node.flops();
    shared ? steps.add(supernode, node) : eliminate(supernode, scratch_[0]);
  }
  if (!shared) return;
  RisingNumber blocks;
  in_stages(steps.pieces, [&](int stage, int piece, int member) {
    if (shared_->failed) return;
    try {
      take_step(steps.steps[stage], piece, blocks, scratch_[member]);
    } catch (...) {
      fail(blocks);
      throw;
    }
  });
}

void SparseCholesky::take_step(const Step& step, int piece, RisingNumber& blocks, AlignedDoubles& memory) {
  const Supernode& node = tree_.supernodes()[step.supernode];
  const auto columns = [&](int per_piece, int count, const auto& work) {
    work(piece * per_piece, std::min(count, (piece + 1) * per_piece));
  };
  double* scratch = reserve(memory, solve_kernels().scratch_size(node.height()));
  switch (step.kind) {
    case Step::Kind::kWhole: return eliminate(step.supernode, memory);
    case Step::Kind::kBegin: return begin_update(step.supernode);
    case Step::Kind::kAssemble:
      return columns(kAssembledColumns, node.height(),
                     [&](int begin, int end) { assemble(step.supernode, begin, end); });
    case Step::Kind::kEliminate:
      if (piece == 0) end_assembly(step.supernode);
      return columns(kEliminatedColumns, node.width,
                     [&](int begin, int end) { eliminate_columns(step, begin, end, blocks, scratch); });
    case Step::Kind::kSubtract:
      return columns(kProductColumns, node.below(),
                     [&](int begin, int end) { subtract_product(step.supernode, begin, end, scratch); });
  }
}

/// Lets go those who wait for a block.
void SparseCholesky::fail(RisingNumber& blocks) {
  shared_->failed = true;
  blocks.raise(std::numeric_limits<int>::max());
}

void SparseCholesky::eliminate(int supernode, AlignedDoubles& memory) {
  const Supernode& node = tree_.supernodes()[supernode];
  begin_update(supernode);
  assemble(supernode, 0, node.height());
  end_assembly(supernode);
  const SolveKernels& kernels = solve_kernels();
  double* scratch = reserve(memory, kernels.scratch_size(node.height()));
  if (kernels.eliminate_panel(panel_of(node), pivots_ == Pivots::kPositive, pivot_.data() + node.first, scratch)) {
    subtract_product(supernode, 0, node.below(), scratch);
  } else {
    shared_->failed = true;
  }
}

void SparseCholesky::begin_update(int supernode) {
  const auto below = static_cast<std::size_t>(tree_.supernodes()[supernode].below());
  updates_[supernode] = shared_->memory.take(below * below);
}

/// Sums the matrix's own entries and the updates of the children, in columns [begin, end) of the panel and, after
/// these, of the update.
void SparseCholesky::assemble(int supernode, int begin, int end) {
  const Supernode& node = tree_.supernodes()[supernode];
  const auto height = static_cast<std::size_t>(node.height()), below = static_cast<std::size_t>(node.below());
  double *panel = panels_.data() + node.panel, *update = updates_[supernode].data();
  const int own_end = std::min(end, node.width);
  if (begin < own_end) {
    std::fill_n(panel + begin * height, (own_end - begin) * height, 0.0);
    const std::vector<EliminationTree::Entry>& entries = tree_.entries()[supernode];
    const auto first = std::lower_bound(entries.begin(), entries.end(), begin * node.height(),
                                        [](const EliminationTree::Entry& a, int target) { return a.target < target; });
    for (auto entry = first; entry != entries.end() && entry->target < own_end * node.height(); ++entry) {
      panel[entry->target] += lower_.valuePtr()[entry->source];
    }
  }
  for (std::size_t c = std::max(begin - node.width, 0); static_cast<int>(c) < end - node.width; ++c) {
    std::fill_n(update + c * below + c, below - c, 0.0);
  }
  for (const int child : node.children) {
    const std::vector<int>& place = tree_.supernodes()[child].in_parent;
    const int size = static_cast<int>(place.size()), last = index_of(place, end);
    int c = index_of(place, begin);
    const std::vector<Run> runs = runs_of(place, c);
    const double* from = updates_[child].data() + static_cast<std::size_t>(c) * size;
    std::size_t run = 0;
    for (; c < last; ++c, from += size) {
      const bool own = place[c] < node.width;
      double* to = own ? panel + place[c] * height : update + (place[c] - node.width) * below;
      const int shift = own ? 0 : node.width;
      if (runs[run].end <= c) ++run;
      add_rows(from, c, runs[run].end, to, place[c] - shift);
      for (std::size_t i = run + 1; i < runs.size(); ++i) {
        add_rows(from, runs[i].begin, runs[i].end, to, place[runs[i].begin] - shift);
      }
    }
  }
}

void SparseCholesky::end_assembly(int supernode) {
  for (const int child : tree_.supernodes()[supernode].children) shared_->memory.put_back(std::move(updates_[child]));
}

/// Eliminates columns of the panel, while other threads eliminate those before and after them. `blocks` counts the
/// blocks of all panels that are eliminated.
void SparseCholesky::eliminate_columns(const Step& step, int begin, int end, RisingNumber& blocks, double* scratch) {
  const Supernode& node = tree_.supernodes()[step.supernode];
  const SolveKernels& kernels = solve_kernels();
  const DensePanel panel = panel_of(node);
  double* pivots = pivot_.data() + node.first;
  for (int first = 0; first < end; first += kPanelBlock) {
    const int next = first + kPanelBlock, counted = step.blocks_before + next / kPanelBlock;
    if (first < begin) {
      blocks.wait_for(counted);
      if (shared_->failed) return;
    } else if (kernels.eliminate_block(panel, first, pivots_ == Pivots::kPositive, pivots)) {
      blocks.raise(counted);
    } else {
      return fail(blocks);
    }
    const int from = std::max(begin, next);
    if (from < end) kernels.subtract_block(panel, first, pivots, from, end, scratch);
  }
}

/// Subtracts the product of the panel's rows below its square from columns [begin, end) of the update.
void SparseCholesky::subtract_product(int supernode, int begin, int end, double* scratch) {
  const Supernode& node = tree_.supernodes()[supernode];
  const DensePanel panel = panel_of(node);
  const DenseFactor below{panel.values + panel.width, panel.height, node.below(), panel.width};
  solve_kernels().subtract_product(below, pivot_.data() + node.first, begin, end, updates_[supernode].data(), scratch);
}

}  // namespace umbilic
