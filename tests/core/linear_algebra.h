// SPDX-License-Identifier: MIT
/// \file
/// Dense products and decompositions by Eigen that the tests of several layers compare with. A compiler takes up to ten
/// seconds for each, so that they are compiled once, here.
#pragma once

#include <Eigen/Core>

namespace umbilic::test {

/// B^T A B.
Eigen::MatrixXd congruent(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Orthonormal columns, orthogonal to those of a, which are independent.
Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& a);

bool positive_definite(const Eigen::MatrixXd& symmetric);

/// A^-1 B of a positive definite A.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// In rising order: those of a symmetric A, and those of the pencil A - lambda B with B positive definite.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a);
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace umbilic::test
