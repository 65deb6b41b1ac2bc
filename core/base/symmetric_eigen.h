// SPDX-License-Identifier: MIT
/// \file
/// Eigenvalues and eigenvectors of small symmetric matrices. Eigen has them too, as templates that take seconds to
/// compile wherever they are used; this is compiled once.
#pragma once

#include <Eigen/Core>

namespace umbilic {

/// A = vectors * diag(values) * vectors^T.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< rising
  Eigen::MatrixXd vectors;  ///< orthogonal; the columns belong to the values
};

/// The decomposition of a symmetric matrix by Jacobi's rotations, n^3 operations in each of about six sweeps. Values
/// are accurate to rounding errors of the largest of them.
SymmetricEigen symmetric_eigen(Eigen::MatrixXd matrix);

}  // namespace umbilic
