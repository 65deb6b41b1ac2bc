// SPDX-License-Identifier: MIT
/// \file
/// The inverse with replaced eigenvalues against matrices whose eigenpairs are known.
#include "solve/absolute_inverse.h"

#include <gtest/gtest.h>

#include <random>

#include "base/symmetric_eigen.h"

namespace umbilic {
namespace {

constexpr int kSize = 120;
constexpr double kShift = 1e-4;

Eigen::SparseMatrix<double> lower_of(const Eigen::MatrixXd& symmetric) {
  Eigen::SparseMatrix<double> lower = symmetric.triangularView<Eigen::Lower>().toDenseMatrix().sparseView();
  lower.makeCompressed();
  return lower;
}

Eigen::MatrixXd random_matrix(int rows, int columns, unsigned seed) {
  std::mt19937 random(seed);
  return Eigen::MatrixXd::NullaryExpr(
      rows, columns, [&](Eigen::Index, Eigen::Index) { return 2.0 * random() / std::mt19937::max() - 1; });
}

/// S = L L^T and H = L Q diag(values) Q^T L^T, so that the eigenvectors are the columns of L^-T Q.
struct Pencil {
  Eigen::MatrixXd product, hessian, vectors;
  Eigen::VectorXd values;

  explicit Pencil(const Eigen::VectorXd& eigenvalues) : values(eigenvalues) {
    const Eigen::MatrixXd any = random_matrix(kSize, kSize, 1);
    const Eigen::MatrixXd q = symmetric_eigen(any + any.transpose()).vectors;
    Eigen::MatrixXd l = Eigen::MatrixXd::Zero(kSize, kSize);
    for (int i = 0; i < kSize; ++i) {
      l(i, i) = 1 + 0.01 * i;
      if (i > 0) l(i, i - 1) = 0.4;
    }
    product = l * l.transpose();
    hessian = l * q * values.asDiagonal() * q.transpose() * l.transpose();
    vectors = l.transpose().triangularView<Eigen::Upper>().solve(q);
  }

  SparseCholesky factored() const {
    SparseCholesky factor(SparseCholesky::Pivots::kNonzero);
    EXPECT_TRUE(factor.factor(lower_of(hessian + kShift * product)));
    return factor;
  }
  /// The inverse of M, from its definition.
  Eigen::VectorXd expected(const Eigen::VectorXd& right) const {
    const Eigen::ArrayXd along = (vectors.transpose() * right).array();
    return vectors * (along / (values.array().abs() + kShift)).matrix();
  }
};

/// Some negative eigenvalues, among them two above -shift, where H + shift S is positive.
Eigen::VectorXd indefinite() {
  Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(kSize, 0.01, 2);
  values.head(8) << -3, -0.4, -0.05, -2e-3, -3e-4, -6e-5, -2e-5, 1e-3;
  return values;
}

TEST(AbsoluteInverse, inverts_the_matrix_whose_negative_eigenvalues_are_replaced_by_their_absolute_values) {
  const Pencil pencil(indefinite());
  const SparseCholesky factor = pencil.factored();
  ASSERT_EQ(factor.negative(), 5);
  const AbsoluteInverse inverse(factor, lower_of(pencil.product), kShift);
  EXPECT_EQ(inverse.replaced(), 7);
  for (unsigned seed = 2; seed < 7; ++seed) {
    const Eigen::VectorXd right = random_matrix(kSize, 1, seed), expected = pencil.expected(right);
    EXPECT_LT((inverse.solve(factor, right) - expected).norm(), 1e-8 * expected.norm());
  }
}

TEST(AbsoluteInverse, is_positive_definite_where_the_factored_matrix_is_not) {
  const Pencil pencil(indefinite());
  const SparseCholesky factor = pencil.factored();
  const AbsoluteInverse inverse(factor, lower_of(pencil.product), kShift);
  const Eigen::VectorXd steepest = pencil.product * pencil.vectors.col(0);
  EXPECT_LT(steepest.dot(factor.solve(steepest)), 0);
  EXPECT_GT(steepest.dot(inverse.solve(factor, steepest)), 0);
}

TEST(AbsoluteInverse, of_a_positive_definite_matrix_is_its_inverse) {
  const Pencil pencil(Eigen::VectorXd::LinSpaced(kSize, 0.01, 2));
  const SparseCholesky factor = pencil.factored();
  const AbsoluteInverse inverse(factor, lower_of(pencil.product), kShift);
  const Eigen::VectorXd right = random_matrix(kSize, 1, 3);
  EXPECT_EQ(inverse.replaced(), 0);
  EXPECT_EQ(inverse.solve(factor, right), factor.solve(right));
}

}  // namespace
}  // namespace umbilic
