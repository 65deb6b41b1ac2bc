// SPDX-License-Identifier: MIT
/// \file
/// Multifrontal L D L^T factorization of a sparse symmetric matrix, done in parts of bounded work and shared among
/// threads.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "base/aligned_doubles.h"
#include "base/threads.h"
#include "solve/elimination_tree.h"
#include "solve/reused_memory.h"
#include "solve/solve_kernels.h"
#include "solve/tree_split.h"

namespace umbilic {

/// P A P^T = L D L^T, L unit lower triangular, D diagonal, without pivoting. P and the pattern of L are computed once
/// and reused while A's pattern stays the same.
///
/// Threads eliminate subtrees of the elimination tree at the same time, then together one supernode after the other at
/// its top. What a supernode subtracts is always computed and summed in the same order, so that any number of threads
/// gives the same bits.
class SparseCholesky {
 public:
  using Matrix = Eigen::SparseMatrix<double>;
  enum class Pivots {
    kPositive,  ///< fails unless A is positive definite
    kNonzero,   ///< also for indefinite A; inaccurate if a leading minor of P A P^T is nearly singular
  };

  explicit SparseCholesky(Pivots pivots) : pivots_(pivots) {}

  /// Begins to factor the matrix with this lower triangle.
  void begin(Matrix lower);
  /// Does about 1e8 floating-point operations, or with several threads the subtrees or 1e9 for each thread. Returns
  /// whether the factorization has ended, successfully or not.
  bool advance();
  /// Fraction of the floating-point operations that are done.
  double progress() const;
  /// Factors the matrix in one call.
  bool factor(Matrix lower);

  /// Whether the matrix is factored.
  bool succeeded() const { return stage_ == Stage::kFactored; }
  /// A^-1 right, column by column. This and `negative` need `succeeded()`.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  /// Number of negative eigenvalues of A, which is that of negative entries of D (Sylvester).
  int negative() const { return static_cast<int>((pivot_.array() < 0).count()); }

 private:
  enum class Stage { kFactoring, kFactored, kFailed };

  struct Step;
  struct Steps;

  DensePanel panel_of(const Supernode& node) { return {panels_.data() + node.panel, node.height(), node.width}; }
  void eliminate_subtrees();
  void eliminate_top();
  void take_step(const Step& step, int piece, RisingNumber& blocks, AlignedDoubles& memory);
  void fail(RisingNumber& blocks);
  void eliminate(int supernode, AlignedDoubles& memory);
  void begin_update(int supernode);
  void assemble(int supernode, int begin, int end);
  void end_assembly(int supernode);
  void eliminate_columns(const Step& step, int begin, int end, RisingNumber& blocks, double* scratch);
  void subtract_product(int supernode, int begin, int end, double* scratch);

  template <class Right>
  void eliminate_right(const Supernode& node, int rows, Right& right, Right& rest) const;
  template <class Right>
  void substitute_back(const Supernode& node, Right& right, Right& coupled) const;
  template <class Right>
  void solve_in_place(Right& right) const;

  Pivots pivots_;
  Matrix lower_;
  EliminationTree tree_;
  Stage stage_ = Stage::kFailed;
  TreeSplit split_;
  int sharing_ = 0;  ///< number of threads that the tree is split for
  bool subtrees_done_ = true;
  std::size_t next_ = 0;  ///< next supernode to eliminate, of those at the top
  double flops_ = 0, flops_done_ = 0;
  std::vector<double> panels_;
  /// Of each supernode: the lower triangle that its parent will add, column-major, until it has done so.
  std::vector<AlignedDoubles> updates_;
  /// What several threads use at the same time.
  struct Shared {
    std::atomic<bool> failed = false;
    ReusedMemory memory;
  };
  std::unique_ptr<Shared> shared_ = std::make_unique<Shared>();
  Eigen::VectorXd pivot_;                ///< D
  std::vector<AlignedDoubles> scratch_;  ///< of each thread
};

}  // namespace umbilic
