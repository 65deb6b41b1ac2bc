// SPDX-License-Identifier: MIT
/// \file
/// Jacobi's rotations, pair by pair.
#include "base/symmetric_eigen.h"

#include <Eigen/Jacobi>
#include <cmath>
#include <limits>
#include <utility>

namespace umbilic {

SymmetricEigen symmetric_eigen(Eigen::MatrixXd matrix) {
  const Eigen::Index n = matrix.rows();
  SymmetricEigen result{{}, Eigen::MatrixXd::Identity(n, n)};
  const double negligible = std::numeric_limits<double>::epsilon() * matrix.norm() / static_cast<double>(n);
  for (bool rotated = true; rotated;) {
    rotated = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = i + 1; j < n; ++j) {
        if (!(std::abs(matrix(i, j)) > negligible)) continue;
        rotated = true;
        Eigen::JacobiRotation<double> rotation;
        rotation.makeJacobi(matrix, i, j);
        matrix.applyOnTheLeft(i, j, rotation.adjoint());
        matrix.applyOnTheRight(i, j, rotation);
        matrix(i, j) = matrix(j, i) = 0;
        result.vectors.applyOnTheRight(i, j, rotation);
      }
    }
  }
  result.values = matrix.diagonal();
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::Index least = 0;
    result.values.tail(n - i).minCoeff(&least);
    if (least == 0) continue;
    std::swap(result.values[i], result.values[i + least]);
    result.vectors.col(i).swap(result.vectors.col(i + least));
  }
  return result;
}

}  // namespace umbilic
