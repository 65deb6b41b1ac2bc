// SPDX-License-Identifier: MIT
/// \file
/// The kernels of the factorization against its definition, for panels of every shape that tiles and blocks can cut.
#include "solve/kernels/dense_elimination.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/each_instruction_set.h"

namespace umbilic::test {
namespace {

/// A random symmetric matrix whose diagonal dominates: positive definite, or with eigenvalues of both signs.
Eigen::MatrixXd random_symmetric(int size, bool positive, unsigned seed) {
  std::mt19937 random(seed);
  Eigen::MatrixXd matrix(size, size);
  for (double& x : matrix.reshaped()) x = 2.0 * random() / std::mt19937::max() - 1;
  matrix = (matrix + matrix.transpose()).eval() / 2;
  for (int i = 0; i < size; ++i) matrix(i, i) += (positive || i % 3 != 1 ? 1 : -1) * (size + 1.0);
  return matrix;
}

struct Eliminated {
  bool succeeded;
  Eigen::MatrixXd panel, update;
  std::vector<double> pivots;
};

Eliminated eliminate(const Eigen::MatrixXd& matrix, int width, bool positive) {
  const SolveKernels& kernels = solve_kernels();
  const auto height = static_cast<int>(matrix.rows());
  Eliminated result{false, matrix.leftCols(width), matrix.bottomRightCorner(height - width, height - width),
                    std::vector<double>(width)};
  std::vector<double> scratch(kernels.scratch_size(height));
  const DensePanel panel{result.panel.data(), height, width};
  result.succeeded = kernels.eliminate_panel(panel, positive, result.pivots.data(), scratch.data());
  const DenseFactor below{result.panel.data() + width, height, height - width, width};
  if (result.succeeded) {
    kernels.subtract_product(below, result.pivots.data(), 0, below.rows, result.update.data(), scratch.data());
  }
  return result;
}

TEST(DenseElimination, factors_panels_of_every_shape) {
  with_each_instruction_set([](InstructionSet set) {
    for (const int width : {1, 3, 8, 9, 16, 17, 30, 48, 131}) {
      for (const int below : {0, 1, 2, 7, 12, 25, 64, 100}) {
        for (const bool positive : {true, false}) {
          SCOPED_TRACE(std::string(name_of(set)) + ", " + std::to_string(width) + " columns, " + std::to_string(below) +
                       " rows below");
          const int height = width + below;
          const Eigen::MatrixXd matrix = random_symmetric(height, positive, static_cast<unsigned>(height));
          const Eliminated result = eliminate(matrix, width, positive);
          ASSERT_TRUE(result.succeeded);
          const Eigen::Map<const Eigen::VectorXd> pivots(result.pivots.data(), width);
          Eigen::MatrixXd lower = result.panel;
          lower.topRows(width).triangularView<Eigen::StrictlyUpper>().setZero();
          EXPECT_EQ(Eigen::VectorXd(lower.diagonal()), pivots);
          lower.diagonal().setOnes();
          const Eigen::MatrixXd product = lower * pivots.asDiagonal() * lower.transpose();
          const double tolerance = 1e-13 * height;
          EXPECT_LE((product - matrix).leftCols(width).cwiseAbs().maxCoeff(), tolerance);
          const Eigen::MatrixXd rest = (matrix - product).bottomRightCorner(below, below) - result.update;
          if (below > 0) {
            EXPECT_LE(Eigen::MatrixXd(rest.triangularView<Eigen::Lower>()).cwiseAbs().maxCoeff(), tolerance);
          }
          if (!positive && width > 1) {
            EXPECT_FALSE(eliminate(matrix, width, true).succeeded);
          }
        }
      }
    }
  });
}

/// The same, `step` columns at a time: what each block contributes to the columns of a piece, from the first block on.
Eliminated eliminate_in_pieces(const Eigen::MatrixXd& matrix, int width, int step) {
  const SolveKernels& kernels = solve_kernels();
  const auto height = static_cast<int>(matrix.rows());
  Eliminated result{true, matrix.leftCols(width), matrix.bottomRightCorner(height - width, height - width),
                    std::vector<double>(width)};
  std::vector<double> scratch(kernels.scratch_size(height));
  const DensePanel panel{result.panel.data(), height, width};
  for (int begin = 0; begin < width; begin += step) {
    const int end = std::min(begin + step, width);
    for (int first = 0; first < end; first += kPanelBlock) {
      if (first >= begin) {
        EXPECT_TRUE(kernels.eliminate_block(panel, first, false, result.pivots.data()));
      }
      const int from = std::max(begin, first + kPanelBlock);
      if (from < end) kernels.subtract_block(panel, first, result.pivots.data(), from, end, scratch.data());
    }
  }
  const DenseFactor below{result.panel.data() + width, height, height - width, width};
  for (int begin = 0; begin < below.rows; begin += step + 5) {
    kernels.subtract_product(below, result.pivots.data(), begin, std::min(begin + step + 5, below.rows),
                             result.update.data(), scratch.data());
  }
  return result;
}

TEST(DenseElimination, gives_the_same_bits_however_columns_are_divided) {
  with_each_instruction_set([](InstructionSet) {
    for (const int width : {16, 37, 131}) {
      for (const int below : {0, 7, 100}) {
        const Eigen::MatrixXd matrix = random_symmetric(width + below, false, 2);
        const Eliminated whole = eliminate(matrix, width, false);
        for (const int step : {16, 48, 64}) {
          const Eliminated parts = eliminate_in_pieces(matrix, width, step);
          EXPECT_EQ(parts.pivots, whole.pivots);
          for (int j = 0; j < width; ++j) {
            EXPECT_EQ(parts.panel.col(j).tail(width + below - j), whole.panel.col(j).tail(width + below - j));
          }
          for (int j = 0; j < below; ++j) {
            EXPECT_EQ(parts.update.col(j).tail(below - j), whole.update.col(j).tail(below - j));
          }
        }
      }
    }
  });
}

TEST(DenseElimination, leaves_what_is_above_the_diagonal) {
  with_each_instruction_set([](InstructionSet) {
    Eigen::MatrixXd matrix = random_symmetric(50, true, 1);
    const Eliminated clean = eliminate(matrix, 20, true);
    matrix.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    const Eliminated spoilt = eliminate(matrix, 20, true);
    ASSERT_TRUE(spoilt.succeeded);
    EXPECT_EQ(spoilt.pivots, clean.pivots);
    for (int j = 0; j < 20; ++j) EXPECT_EQ(spoilt.panel.col(j).tail(50 - j), clean.panel.col(j).tail(50 - j));
    for (int j = 0; j < 30; ++j) EXPECT_EQ(spoilt.update.col(j).tail(30 - j), clean.update.col(j).tail(30 - j));
  });
}

TEST(DenseElimination, ends_at_pivots_that_are_zero_or_not_finite) {
  with_each_instruction_set([](InstructionSet) {
    for (const double bad : {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
      for (const int at : {0, 5, 18}) {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(25, 25);
        matrix(at, at) = bad;
        EXPECT_FALSE(eliminate(matrix, 20, false).succeeded) << bad << " at " << at;
      }
    }
    const Eigen::MatrixXd negative = -Eigen::MatrixXd::Identity(25, 25);
    EXPECT_TRUE(eliminate(negative, 20, false).succeeded);
    EXPECT_FALSE(eliminate(negative, 20, true).succeeded);
  });
}

}  // namespace
}  // namespace umbilic::test
