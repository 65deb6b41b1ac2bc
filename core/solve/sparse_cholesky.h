// SPDX-License-Identifier: MIT
/// \file
/// Multifrontal L D L^T factorization of a sparse symmetric matrix, in steps of bounded work.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "solve/elimination_tree.h"

namespace umbilic {

/// P A P^T = L D L^T, L unit lower triangular, D diagonal, without pivoting. The order P and the pattern of L are found
/// once and kept as long as A's pattern stays the same.
class SparseCholesky {
 public:
  using Matrix = Eigen::SparseMatrix<double>;
  enum class Pivots {
    kPositive,  ///< fails unless A is positive definite
    kNonzero,   ///< as accurate as A is far from having a singular leading minor
  };

  explicit SparseCholesky(Pivots pivots) : pivots_(pivots) {}

  /// Starts to factor the matrix with this lower triangle.
  void begin(Matrix lower);
  /// Does a part of the work, about a hundred million floating-point operations; returns whether it has ended, be it in
  /// failure.
  bool advance();
  /// Fraction of the floating-point operations that are done.
  double progress() const;
  /// All of the above.
  bool factor(Matrix lower);

  /// Whether the matrix is factored.
  bool succeeded() const { return stage_ == Stage::kFactored; }
  /// A^-1 right, column by column. Needs `succeeded()`, as the next.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  /// Negative eigenvalues of A: those of D (Sylvester).
  int negative() const { return static_cast<int>((pivot_.array() < 0).count()); }

 private:
  enum class Stage { kFactoring, kFactored, kFailed };
  using Panel = Eigen::Map<Eigen::MatrixXd>;

  void assemble(const Supernode& node, double* panel, Eigen::MatrixXd& update);
  bool eliminate(int supernode);
  bool eliminate_columns(Panel panel, int first, int count, Eigen::Ref<Eigen::VectorXd> pivot) const;
  template <class Right>
  void solve_in_place(Right& right) const;

  Pivots pivots_;
  Matrix lower_;
  EliminationTree tree_;
  Stage stage_ = Stage::kFailed;
  int next_ = 0;  ///< supernode to eliminate
  double flops_ = 0, flops_done_ = 0;
  std::vector<double> panels_;
  std::vector<Eigen::MatrixXd> updates_;  ///< lower triangles that wait for the parents, by supernode
  Eigen::VectorXd pivot_;                 ///< D
};

}  // namespace umbilic
