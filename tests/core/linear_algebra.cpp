// SPDX-License-Identifier: MIT
/// \file
/// Calls of Eigen.
#include "linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <vector>

namespace umbilic::test {

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a * b; }

/// In loops that leave out the zeros of b, most of its entries in many tests. The sanitized tests would use the
/// sanitized core's instance of Eigen's product.
Eigen::MatrixXd congruent(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::Index rows = b.rows(), columns = b.cols();
  struct Term {
    Eigen::Index row;
    double factor;
  };
  std::vector<std::vector<Term>> terms(columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) {
      if (b.data()[j * rows + i] != 0) terms[j].push_back({i, b.data()[j * rows + i]});
    }
  }
  Eigen::MatrixXd result(columns, columns);
  std::vector<double> product(rows);  // a column of A B
  for (Eigen::Index j = 0; j < columns; ++j) {
    std::fill(product.begin(), product.end(), 0.0);
    double* const sum = product.data();
    for (const Term& term : terms[j]) {
      const double* const column = a.data() + term.row * rows;
      for (Eigen::Index i = 0; i < rows; ++i) sum[i] += term.factor * column[i];
    }
    for (Eigen::Index i = 0; i < columns; ++i) {
      double entry = 0;
      for (const Term& term : terms[i]) entry += term.factor * sum[term.row];
      result.data()[j * columns + i] = entry;
    }
  }
  return result;
}

Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& a) {
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(a).householderQ();
  return q.rightCols(a.rows() - a.cols());
}

bool positive_definite(const Eigen::MatrixXd& symmetric) {
  return Eigen::LLT<Eigen::MatrixXd>(symmetric).info() == Eigen::Success;
}

Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return Eigen::LLT<Eigen::MatrixXd>(a).solve(b);
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace umbilic::test
