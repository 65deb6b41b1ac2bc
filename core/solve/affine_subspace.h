// SPDX-License-Identifier: MIT
/// \file
/// The solutions of sparse linear equations as an affine subspace with coordinates of its own: exact linear
/// constraints.
///
/// What must hold exactly is not penalized but eliminated: the solutions of A q = b are q = q0 + N y, where the columns
/// of N are a basis of the vectors with A d = 0. A minimizer that moves y meets every equation all the way.
///
///     const AffineSubspace solutions(rows, start);
///     if (!solutions.contradiction().empty()) return error_of(solutions.contradiction());
///     q = solutions.point(y);                             // y = 0: the solution nearest to `start`
///     gradient_y = solutions.basis().transpose() * gradient_q;
///     forces = solutions.multipliers(gradient_q);         // how the minimum changes with b
///
/// A row of A touches few unknowns, so N is sparse as well: rows that share unknowns, directly or through others, form
/// a cluster, and only the unknowns of one cluster are coupled. Unknowns that no row touches keep a unit column.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "solve/sparse_cholesky.h"

namespace umbilic {

/// The equations A q = b, row by row.
struct LinearRows {
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix;
  Eigen::VectorXd right;
  /// Of each row: by how much its value changes, up to a modest factor, when its unknowns move by the size of the
  /// problem, if it is not degenerate. A row whose entries are below 1e-6 of this is taken for 0 = b; whether
  /// equations contradict each other is judged relative to it.
  Eigen::VectorXd scales;

  int count() const { return static_cast<int>(matrix.rows()); }
};

class AffineSubspace {
 public:
  /// Equations that follow from others must hold up to this part of their scales; if they do they are dropped, else
  /// there is no solution.
  static constexpr double kConsistent = 1e-11;

  /// `start` chooses the origin of the coordinates y.
  AffineSubspace(LinearRows rows, const Eigen::VectorXd& start);

  /// A smallest set of equations without a common solution, sorted: without any one of them, the others have one. Of
  /// several such sets that were met, one with the fewest. Empty if there are solutions; otherwise nothing below may be
  /// called.
  const std::vector<int>& contradiction() const { return contradiction_; }
  /// The equations that follow from those before them and were dropped, sorted.
  const std::vector<int>& redundant() const { return redundant_; }

  int dimension() const { return static_cast<int>(basis_.cols()); }
  /// N. The columns of clusters of at most kOrthonormalCluster unknowns are orthonormal, so that distances in y are
  /// distances in q; each column of a larger one moves one free unknown by 1.
  const Eigen::SparseMatrix<double>& basis() const { return basis_; }
  static constexpr int kOrthonormalCluster = 160;
  bool orthonormal() const { return orthonormal_; }
  /// q0.
  const Eigen::VectorXd& origin() const { return origin_; }

  /// q0 + N y.
  Eigen::VectorXd point(const Eigen::VectorXd& y) const { return origin_ + basis_ * y; }
  /// The solution nearest to q.
  Eigen::VectorXd nearest(const Eigen::VectorXd& q) const;
  /// The coordinates y of the solution nearest to q.
  Eigen::VectorXd coordinates(const Eigen::VectorXd& q) const;

  /// The lambda, one per row, for which A^T lambda is nearest to g; 0 for dropped rows. If g is the gradient of f at
  /// its minimum among the solutions, lambda is the derivative of that minimum by b.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& g) const;

  /// An orthonormal basis of the directions d = D c, for the columns of D, with A d = 0. A combination counts as such
  /// if A d is below 1e-6 of what the rows could make of directions of that size.
  Eigen::MatrixXd kept(const Eigen::MatrixXd& directions) const;

 private:
  void eliminate();
  void build_basis(const class RowElimination& elimination);

  LinearRows rows_;          // scaled to length 1
  Eigen::VectorXd lengths_;  // what the rows were divided by
  std::vector<int> independent_, redundant_, contradiction_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_;  // the independent rows
  Eigen::VectorXd right_;
  SparseCholesky products_{SparseCholesky::Pivots::kPositive};  // of the independent rows with one another
  Eigen::SparseMatrix<double> basis_;
  std::vector<int> free_unknown_;  // of each column in a large cluster: the unknown that it moves by 1; else -1
  bool orthonormal_ = true;
  Eigen::VectorXd origin_;
};

}  // namespace umbilic
