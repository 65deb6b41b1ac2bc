// SPDX-License-Identifier: MIT
/// \file
/// Newton's steps where the second derivatives are not positive: a few negative eigenvalues are replaced by their
/// absolute values, and all other directions keep theirs.
///
/// A multiple of S that makes H + shift S positive definite must be as large as the most negative eigenvalue, and damps
/// every soft direction, though only few are negative. Here the shift may be much smaller. With the eigenpairs
/// H v = lambda S v, v^T S v = 1, those of lambda < 0 are found one by one, and
///
///   M = sum over lambda of (|lambda| + shift) (S v) (S v)^T
///
/// is positive definite: its step leaves a saddle along the negative directions, and is Newton's along the others.
#pragma once

#include "solve/sparse_cholesky.h"

namespace umbilic {

/// Applies M^-1. The eigenpairs are those of (H + shift S)^-1 S at the ends of its spectrum, which Lanczos' iteration
/// finds first: theta = 1 / (lambda + shift) is negative or above 1 / shift if and only if lambda < 0.
class AbsoluteInverse {
 public:
  AbsoluteInverse() = default;
  /// `factor` has factored H + shift S; `product` is the lower triangle of S, which is positive definite; shift > 0.
  AbsoluteInverse(const SparseCholesky& factor, const Eigen::SparseMatrix<double>& product, double shift);

  /// Whether all negative eigenvalues of the factored matrix were found. Otherwise M may not be positive definite.
  bool complete() const { return complete_; }

  /// With the same factor.
  Eigen::VectorXd solve(const SparseCholesky& factor, const Eigen::VectorXd& right) const;
  /// The v with lambda < 0 that were found, S-orthonormal; as many columns as were `replaced`.
  const Eigen::MatrixXd& vectors() const { return vectors_; }
  /// Number of eigenvalues that were replaced.
  int replaced() const { return static_cast<int>(vectors_.cols()); }

 private:
  bool complete_ = true;
  Eigen::MatrixXd vectors_;      // the v with lambda < 0
  Eigen::VectorXd corrections_;  // 1 / (|lambda| + shift) - theta
};

}  // namespace umbilic
