// SPDX-License-Identifier: MIT
/// \file
/// The sparse factorization against dense ones, on patterns of many kinds.
#include "solve/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <limits>
#include <random>
#include <string>

#include "linear_algebra.h"

namespace umbilic {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Pivots = SparseCholesky::Pivots;
using Edges = std::vector<std::pair<int, int>>;

struct Pattern {
  std::string name;
  int unknowns;
  Edges edges;
};

/// A grid whose points see all points up to `reach` away, with `block` unknowns at each.
Pattern grid(int side, int reach, int block) {
  Pattern result{"grid", side * side * block, {}};
  for (int p = 0; p < side * side; ++p) {
    for (int q = 0; q <= p; ++q) {
      if (std::abs(p % side - q % side) > reach || p / side - q / side > reach) continue;
      for (int i = 0; i < block; ++i) {
        for (int j = 0; j < block; ++j) result.edges.emplace_back(block * p + i, block * q + j);
      }
    }
  }
  result.name += "_of_" + std::to_string(side) + "_reach_" + std::to_string(reach) + "_block_" + std::to_string(block);
  return result;
}

std::vector<Pattern> patterns() {
  std::vector<Pattern> result = {{"nothing", 0, {}}, {"one", 1, {}}, {"no_edges", 20, {}}};
  Pattern arrow{"arrow", 40, {}}, reversed{"reversed_arrow", 40, {}}, chain{"chain", 50, {}}, dense{"dense", 70, {}};
  Pattern parts{"two_parts", 60, {}}, random{"random", 150, {}};
  for (int i = 1; i < 50; ++i) {
    if (i < 40) arrow.edges.emplace_back(39, i - 1);
    if (i < 40) reversed.edges.emplace_back(i, 0);
    chain.edges.emplace_back(i, i - 1);
  }
  for (int i = 0; i < 70; ++i) {
    for (int j = 0; j < i; ++j) dense.edges.emplace_back(i, j);
  }
  for (int i = 2; i < 60; ++i) parts.edges.emplace_back(i, i - 2);
  std::mt19937 generator(5);
  for (int k = 0; k < 400; ++k) random.edges.emplace_back(generator() % 150, generator() % 150);
  result.insert(result.end(), {arrow, reversed, chain, dense, parts, random});
  result.insert(result.end(), {grid(12, 1, 1), grid(18, 3, 1), grid(9, 2, 3), grid(7, 1, 2)});
  return result;
}

/// Symmetric with random entries in [-1, 1] on the edges, and on the diagonal what makes it positive definite, or both
/// signs of it.
Eigen::MatrixXd random_matrix(const Pattern& pattern, bool definite, int seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&] { return 2.0 * generator() / std::mt19937::max() - 1; };
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(pattern.unknowns, pattern.unknowns);
  for (const auto& [i, j] : pattern.edges) {
    if (i != j) result(i, j) = result(j, i) = uniform();
  }
  for (int i = 0; i < pattern.unknowns; ++i) {
    const double dominant = 0.1 + result.col(i).cwiseAbs().sum();
    result(i, i) = definite || uniform() > 0 ? dominant : -dominant;
  }
  return result;
}

Matrix lower(const Eigen::MatrixXd& matrix) {
  return Matrix(Eigen::MatrixXd(matrix.triangularView<Eigen::Lower>()).sparseView());
}

Eigen::MatrixXd random_right(Eigen::Index rows, int columns) {
  std::mt19937 generator(11);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return 2.0 * generator() / std::mt19937::max() - 1; });
}

class SparseCholeskyOf : public testing::TestWithParam<Pattern> {};
INSTANTIATE_TEST_SUITE_P(Patterns, SparseCholeskyOf, testing::ValuesIn(patterns()),
                         [](const auto& tested) { return tested.param.name; });

// Dominant diagonals keep condition numbers below about 1e3, so that both solutions have 12 digits.
TEST_P(SparseCholeskyOf, solves_what_dense_cholesky_solves) {
  const Eigen::MatrixXd matrix = random_matrix(GetParam(), true, 1);
  SparseCholesky sparse(Pivots::kPositive);
  ASSERT_TRUE(sparse.factor(lower(matrix)));
  const Eigen::MatrixXd right = random_right(matrix.rows(), 4);
  const Eigen::MatrixXd expected = test::solve(matrix, right);
  const Eigen::MatrixXd solved = sparse.solve(right);
  EXPECT_LE((solved - expected).norm(), 1e-12 * expected.norm());
  for (int c = 0; c < 4; ++c) {
    const Eigen::VectorXd one = right.col(c);
    EXPECT_LE((sparse.solve(one) - expected.col(c)).norm(), 1e-12 * expected.norm());
  }
  EXPECT_EQ(sparse.negative(), 0);
}

// A^-1, one column for each unit vector, times A.
TEST_P(SparseCholeskyOf, inverts_indefinite_matrices) {
  const Eigen::MatrixXd matrix = random_matrix(GetParam(), false, 2);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  SparseCholesky sparse(Pivots::kNonzero);
  ASSERT_TRUE(sparse.factor(lower(matrix)));
  EXPECT_LE((matrix * sparse.solve(identity) - identity).norm(), 1e-11 * (1 + identity.norm()));
}

TEST_P(SparseCholeskyOf, counts_the_negative_eigenvalues) {
  const Eigen::MatrixXd matrix = random_matrix(GetParam(), false, 3);
  SparseCholesky sparse(Pivots::kNonzero);
  ASSERT_TRUE(sparse.factor(lower(matrix)));
  if (matrix.size() == 0) return;
  const Eigen::VectorXd values = test::eigenvalues(matrix);
  EXPECT_EQ(sparse.negative(), (values.array() < 0).count());
}

TEST_P(SparseCholeskyOf, refuses_exactly_the_matrices_that_are_not_definite) {
  const Eigen::MatrixXd matrix = random_matrix(GetParam(), true, 4);
  if (matrix.size() == 0) return;
  const double least = test::eigenvalues(matrix)[0];
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  SparseCholesky sparse(Pivots::kPositive);
  EXPECT_FALSE(sparse.factor(lower(matrix - (1 + 1e-9) * least * identity)));
  EXPECT_TRUE(sparse.factor(lower(matrix - (1 - 1e-9) * least * identity)));
}

TEST_P(SparseCholeskyOf, gives_the_same_bits_again_after_other_matrices) {
  const Matrix matrix = lower(random_matrix(GetParam(), true, 6));
  const Eigen::VectorXd right = random_right(matrix.rows(), 1);
  SparseCholesky fresh(Pivots::kPositive), used(Pivots::kPositive);
  used.factor(lower(random_matrix(GetParam(), true, 7)));
  used.factor(lower(random_matrix(GetParam(), false, 8)));
  used.factor(lower(random_matrix(grid(4, 1, 1), true, 9)));
  ASSERT_TRUE(fresh.factor(matrix));
  ASSERT_TRUE(used.factor(matrix));
  EXPECT_EQ(fresh.solve(right), used.solve(right));
}

// Positions are a permutation, and every panel holds its couplings in its ancestors' columns.
TEST_P(SparseCholeskyOf, has_an_elimination_tree_that_covers_every_unknown_once) {
  const EliminationTree tree(lower(random_matrix(GetParam(), true, 1)));
  std::vector<int> met(GetParam().unknowns, 0);
  for (int position : tree.positions()) ++met.at(position);
  EXPECT_EQ(met, std::vector<int>(GetParam().unknowns, 1));
  int next = 0;
  for (const Supernode& node : tree.supernodes()) {
    EXPECT_EQ(node.first, next);
    next += node.width;
    for (int child : node.children) {
      const Supernode& below = tree.supernodes()[child];
      ASSERT_EQ(below.in_parent.size(), below.rows.size());
      for (std::size_t i = 0; i < below.rows.size(); ++i) {
        const int place = below.in_parent[i];
        EXPECT_EQ(below.rows[i], place < node.width ? node.first + place : node.rows[place - node.width]);
      }
    }
  }
  EXPECT_EQ(next, GetParam().unknowns);
}

TEST(SparseCholesky, refuses_what_is_not_a_number) {
  for (const Pivots pivots : {Pivots::kPositive, Pivots::kNonzero}) {
    Matrix matrix = lower(random_matrix(grid(6, 1, 3), true, 1));
    matrix.valuePtr()[17] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(SparseCholesky(pivots).factor(matrix));
  }
}

TEST(SparseCholesky, takes_several_steps_on_large_matrices_and_tells_how_far_it_is) {
  const Matrix matrix = lower(random_matrix(grid(24, 4, 3), true, 1));
  SparseCholesky sparse(Pivots::kPositive);
  sparse.begin(matrix);
  double progress = 0;
  int steps = 1;
  for (; !sparse.advance(); ++steps) {
    EXPECT_GT(sparse.progress(), progress);
    EXPECT_LT(sparse.progress(), 1);
    progress = sparse.progress();
  }
  EXPECT_GT(steps, 1);
  EXPECT_EQ(sparse.progress(), 1);
  EXPECT_TRUE(sparse.succeeded());
}

}  // namespace
}  // namespace umbilic
