// SPDX-License-Identifier: MIT
/// \file
/// Eigenvalues of matrices that are made from them.
#include "base/symmetric_eigen.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "linear_algebra.h"

namespace umbilic::test {
namespace {

/// An orthogonal matrix: a product of reflections at random planes.
Eigen::MatrixXd orthogonal(int n, unsigned seed) {
  std::mt19937 random(seed);
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i < n; ++i) {
    Eigen::VectorXd normal(n);
    for (double& value : normal) value = 2.0 * random() / std::mt19937::max() - 1;
    normal.normalize();
    result -= 2 * normal * (normal.transpose() * result);
  }
  return result;
}

void expect_values(const Eigen::VectorXd& rising) {
  const int n = static_cast<int>(rising.size());
  const Eigen::MatrixXd q = orthogonal(n, 1);
  const Eigen::MatrixXd product = congruent(rising.asDiagonal(), q.transpose());
  const Eigen::MatrixXd a = (product + product.transpose()) / 2;
  const SymmetricEigen eigen = symmetric_eigen(a);
  const double rounding = 50 * n * std::numeric_limits<double>::epsilon() * rising.cwiseAbs().maxCoeff();
  EXPECT_LE((eigen.values - rising).cwiseAbs().maxCoeff(), rounding) << rising.transpose();
  EXPECT_LE((congruent(a, eigen.vectors) - Eigen::MatrixXd(eigen.values.asDiagonal())).norm(), rounding);
  EXPECT_LT((congruent(Eigen::MatrixXd::Identity(n, n), eigen.vectors) - Eigen::MatrixXd::Identity(n, n)).norm(),
            1e-14 * n);
}

TEST(SymmetricEigen, finds_the_values_from_which_a_matrix_is_made_and_vectors_that_diagonalize_it) {
  expect_values(Eigen::Vector3d(-1, 2, 5));
  expect_values(Eigen::Vector4d(-3, -3, -3, 3));             // equal and opposite
  expect_values(Eigen::Vector3d(1e-12, 1, 1e12));            // apart
  expect_values(Eigen::Vector3d(0, 0, 1e-200));              // tiny, of rank one
  expect_values(Eigen::VectorXd::LinSpaced(12, -5.5, 5.5));  // of both signs
}

TEST(SymmetricEigen, leaves_diagonal_matrices_as_they_are_and_sorts_them) {
  const SymmetricEigen eigen = symmetric_eigen(Eigen::Vector3d(3, -1, 2).asDiagonal());
  EXPECT_EQ(eigen.values, Eigen::Vector3d(-1, 2, 3));
  EXPECT_EQ(eigen.vectors, (Eigen::Matrix3d{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(symmetric_eigen(Eigen::Matrix3d::Zero()).values, Eigen::Vector3d::Zero());
}

TEST(SymmetricEigen, ends_without_numbers) {
  const Eigen::Matrix2d nothing = Eigen::Matrix2d::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(symmetric_eigen(nothing).vectors.allFinite());
}

}  // namespace
}  // namespace umbilic::test
