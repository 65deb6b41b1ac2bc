// SPDX-License-Identifier: MIT
/// \file
/// Multifrontal L D L^T factorization of a sparse symmetric matrix, done in parts of bounded work.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "base/aligned_doubles.h"
#include "solve/elimination_tree.h"

namespace umbilic {

/// P A P^T = L D L^T, L unit lower triangular, D diagonal, without pivoting. P and the pattern of L are computed once
/// and reused while A's pattern stays the same.
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
  /// Does about 1e8 floating-point operations. Returns whether the factorization has ended, successfully or not.
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

  AlignedDoubles take_memory(std::size_t size);
  void assemble(const Supernode& node, double* panel, double* update);
  bool eliminate(int supernode);
  template <class Right>
  void solve_in_place(Right& right) const;

  Pivots pivots_;
  Matrix lower_;
  EliminationTree tree_;
  Stage stage_ = Stage::kFailed;
  int next_ = 0;  ///< next supernode to eliminate
  double flops_ = 0, flops_done_ = 0;
  std::vector<double> panels_;
  /// Of each supernode: the lower triangle that its parent will add, column-major, until it has done so.
  std::vector<AlignedDoubles> updates_;
  std::vector<AlignedDoubles> free_;  ///< memory of updates that have been added
  Eigen::VectorXd pivot_;             ///< D
  AlignedDoubles scratch_;
};

}  // namespace umbilic
