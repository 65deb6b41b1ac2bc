// SPDX-License-Identifier: MIT
/// \file
/// Lanczos' iteration with full reorthogonalization in the product S.
#include "solve/absolute_inverse.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/symmetric_eigen.h"

namespace umbilic {
namespace {

/// Steps of the iteration: so many for each negative eigenvalue of the factored matrix, and some more.
constexpr int kStepsPerEigenvalue = 3, kMoreSteps = 30;

/// The space is invariant where a new direction is shorter than this, relative to the vector that it comes from.
constexpr double kInvariant = 1e-12;

/// An S-orthonormal basis Q of a Krylov space of K^-1 S, and Q^T S K^-1 S Q.
struct KrylovSpace {
  Eigen::MatrixXd basis, matrix;
};

KrylovSpace krylov_space(const SparseCholesky& factor, const Eigen::SparseMatrix<double>& product, int steps) {
  const Eigen::Index size = product.rows();
  const Eigen::SparseMatrix<double> full = product.selfadjointView<Eigen::Lower>();
  Eigen::MatrixXd basis(size, steps), images(size, steps);  // Q and S Q
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(steps, steps);
  std::mt19937 random(1);
  Eigen::VectorXd next(size);
  for (double& value : next) value = 2.0 * random() / std::mt19937::max() - 1;
  Eigen::VectorXd image = full * next;
  double length = std::sqrt(next.dot(image));
  int count = 0;
  while (count < steps) {
    basis.col(count) = next / length;
    images.col(count) = image / length;
    next = factor.solve(Eigen::VectorXd(images.col(count)));
    ++count;
    const double whole = next.norm();
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd along = images.leftCols(count).transpose() * next;
      matrix.col(count - 1).head(count) += along;
      next -= basis.leftCols(count) * along;
    }
    image = full * next;
    length = std::sqrt(std::max(0.0, next.dot(image)));
    if (!(next.norm() > kInvariant * whole)) break;
  }
  matrix = Eigen::MatrixXd(matrix.topLeftCorner(count, count).selfadjointView<Eigen::Upper>());
  return {basis.leftCols(count), matrix};
}

}  // namespace

AbsoluteInverse::AbsoluteInverse(const SparseCholesky& factor, const Eigen::SparseMatrix<double>& product,
                                 double shift) {
  const int negative = factor.negative();
  if (negative == 0) return;
  const int size = static_cast<int>(product.rows());
  const KrylovSpace space = krylov_space(factor, product, std::min(size, kStepsPerEigenvalue * negative + kMoreSteps));
  const SymmetricEigen eigen = symmetric_eigen(space.matrix);
  complete_ = (eigen.values.array() < 0).count() == negative;
  std::vector<Eigen::Index> replaced;
  for (Eigen::Index i = 0; i < eigen.values.size(); ++i) {
    if (eigen.values[i] < 0 || eigen.values[i] > 1 / shift) replaced.push_back(i);
  }
  vectors_ = space.basis * eigen.vectors(Eigen::all, replaced);
  const Eigen::ArrayXd theta = eigen.values(replaced).array();
  corrections_ = 1 / ((1 / theta - shift).abs() + shift) - theta;
}

Eigen::VectorXd AbsoluteInverse::solve(const SparseCholesky& factor, const Eigen::VectorXd& right) const {
  Eigen::VectorXd result = factor.solve(right);
  if (vectors_.cols() > 0) result += vectors_ * corrections_.cwiseProduct(vectors_.transpose() * right);
  return result;
}

}  // namespace umbilic
