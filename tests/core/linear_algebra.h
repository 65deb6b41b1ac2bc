// SPDX-License-Identifier: MIT
/// \file
/// Eigen's dense products and decompositions for comparisons in the tests of several layers. Compilers take up to ten
/// seconds for each, so they are compiled once, here.
#pragma once

#include <Eigen/Core>

namespace umbilic::test {

/// A B.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// B^T A B.
Eigen::MatrixXd congruent(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Orthonormal columns that are orthogonal to those of a. The columns of a must be independent.
Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& a);

bool positive_definite(const Eigen::MatrixXd& symmetric);

/// A^-1 B of a positive definite A.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Eigenvalues in ascending order: those of a symmetric A, and those of the pencil A - lambda B with B positive
/// definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a);
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace umbilic::test
