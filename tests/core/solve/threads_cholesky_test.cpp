// SPDX-License-Identifier: MIT
/// \file
/// Sparse factorizations have the same bits from any number of threads, whatever the shape of the elimination tree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "base/each_instruction_set.h"
#include "base/with_threads.h"
#include "solve/sparse_cholesky.h"

namespace umbilic::test {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Pivots = SparseCholesky::Pivots;

/// The lower triangle of a matrix that couples points of a grid up to `reach` apart, with three unknowns each; `parts`
/// such grids that do not touch. Its diagonal makes it positive definite, apart from the unknowns in `negative`.
Matrix grid_matrix(int side, int reach, int parts, const std::vector<int>& negative = {}) {
  std::vector<Eigen::Triplet<double>> entries;
  const int size = 3 * side * side;
  for (int p = 0; p < side * side; ++p) {
    for (int q = 0; q <= p; ++q) {
      if (std::abs(p % side - q % side) > reach || p / side - q / side > reach) continue;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          const int row = 3 * p + i, column = 3 * q + j;
          if (row < column) continue;
          const double value = row == column ? 3.0 * (2 * reach + 1) * (2 * reach + 1)
                                             : static_cast<double>((31 * row + 17 * column) % 97) / 97 - 0.5;
          for (int part = 0; part < parts; ++part) {
            entries.emplace_back(part * size + row, part * size + column, value);
          }
        }
      }
    }
  }
  for (const int unknown : negative) entries.emplace_back(unknown, unknown, -1e5);
  Matrix matrix(parts * size, parts * size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

struct Shape {
  std::string name;
  int side, reach, parts;
  Matrix matrix(const std::vector<int>& negative = {}) const { return grid_matrix(side, reach, parts, negative); }
};

const Shape kShapes[] = {{"a tree of separators", 24, 2, 1},
                         {"one dense supernode", 11, 11, 1},
                         {"several trees", 14, 2, 5},
                         {"too little to share", 5, 1, 1}};

TEST(SparseCholesky, has_the_same_bits_from_any_number_of_threads) {
  with_each_instruction_set([](InstructionSet) {
    for (const Shape& shape : kShapes) {
      SCOPED_TRACE(shape.name);
      const Matrix matrix = shape.matrix({1, 7, 30});
      const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 2);
      Eigen::MatrixXd rights(matrix.rows(), 3);
      rights << right, right.reverse(), right.cwiseAbs2();
      Eigen::VectorXd solved;
      Eigen::MatrixXd all_solved;
      for (const int threads : kThreadCounts) {
        const WithThreads with(threads);
        SparseCholesky factor(Pivots::kNonzero);
        for (int round = 0; round < 2; ++round) {
          ASSERT_TRUE(factor.factor(matrix));
          if (threads == 1 && round == 0) {
            solved = factor.solve(right);
            all_solved = factor.solve(rights);
            const Eigen::VectorXd back = matrix.selfadjointView<Eigen::Lower>() * solved;
            EXPECT_LT((back - right).norm(), 1e-11 * right.norm());
          }
          EXPECT_EQ(factor.negative(), 3);
          EXPECT_EQ(factor.solve(right), solved);
          EXPECT_EQ(factor.solve(rights), all_solved);
        }
      }
    }
  });
}

TEST(SparseCholesky, fails_with_any_number_of_threads_and_then_factors_again) {
  for (const Shape& shape : kShapes) {
    const Matrix good = shape.matrix();
    for (const int at : {0, static_cast<int>(good.rows()) / 2, static_cast<int>(good.rows()) - 1}) {
      for (const int threads : kThreadCounts) {
        const WithThreads with(threads);
        SparseCholesky factor(Pivots::kPositive);
        EXPECT_FALSE(factor.factor(shape.matrix({at}))) << shape.name;
        EXPECT_TRUE(factor.factor(good));
      }
    }
  }
}

TEST(SparseCholesky, may_be_used_with_other_numbers_of_threads_than_it_was_begun_with) {
  const Matrix matrix = kShapes[0].matrix();
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 2);
  SparseCholesky plain(Pivots::kPositive);
  ASSERT_TRUE(plain.factor(matrix));
  SparseCholesky factor(Pivots::kPositive);
  {
    const WithThreads three(3);
    factor.begin(matrix);
    factor.advance();
  }
  while (!factor.advance()) {
  }
  const WithThreads two(2);
  EXPECT_EQ(factor.solve(right), plain.solve(right));
}

TEST(TreeSplit, has_each_supernode_once_and_subtrees_that_need_nothing_from_each_other) {
  for (const Shape& shape : kShapes) {
    const EliminationTree tree(shape.matrix());
    const std::vector<Supernode>& nodes = tree.supernodes();
    for (const int threads : kThreadCounts) {
      const TreeSplit split(tree, threads);
      std::vector<int> order;
      for (const std::vector<int>& subtree : split.subtrees) order.insert(order.end(), subtree.begin(), subtree.end());
      order.insert(order.end(), split.top.begin(), split.top.end());
      ASSERT_EQ(order.size(), nodes.size());
      std::vector<bool> seen(nodes.size(), false);
      for (const int s : order) {
        for (const int child : nodes[s].children) {
          EXPECT_TRUE(seen[child]) << "children come first";
          EXPECT_TRUE(split.subtree_of[s] < 0 || split.subtree_of[s] == split.subtree_of[child]);
        }
        EXPECT_FALSE(seen[s]);
        seen[s] = true;
      }
      for (std::size_t s = 0; s < nodes.size(); ++s) {
        for (int i = 0; i < nodes[s].below(); ++i) {
          const auto owner = std::find_if(nodes.begin(), nodes.end(), [&](const Supernode& node) {
            return nodes[s].rows[i] >= node.first && nodes[s].rows[i] < node.first + node.width;
          });
          const bool inside = split.subtree_of[owner - nodes.begin()] == split.subtree_of[s];
          EXPECT_EQ(i < split.inner_rows[s], inside);
        }
      }
      EXPECT_EQ(split.shared, threads > 1 && shape.name != "too little to share");
      if (!split.shared) {
        EXPECT_TRUE(split.subtrees.empty());
      }
    }
  }
}

}  // namespace
}  // namespace umbilic::test
