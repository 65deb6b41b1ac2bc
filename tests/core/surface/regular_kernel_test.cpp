// SPDX-License-Identifier: MIT
/// \file
/// Sum factorization against the dense table of the same samples, and its transpose.
#include "surface/regular_kernel.h"

#include <gtest/gtest.h>

#include "mesh/rough_cages.h"
#include "surface/basis_table.h"

namespace umbilic::test {
namespace {

constexpr int kDerivativeCounts[] = {kFirstOrderCount, kSecondOrderCount, kThirdOrderCount};

TEST(RegularKernel, equals_the_dense_basis_table) {
  for (int n = 1; n <= 9; ++n) {
    const RegularKernel kernel(n);
    const BasisTable table = basis_table({}, tensor_rule(n), 1, kDerivativeCount);
    const Points points = Random(n).points(16);
    const Points dense = table.view(1, table.basis) * points;
    const int width = kernel.samples() / n;
    EXPECT_GE(width, n);
    std::vector<double> scratch(kernel.scratch_size());
    for (const int derivatives : kDerivativeCounts) {
      std::vector<double> jets(3 * derivatives * kernel.samples());
      kernel.jets(points.data(), derivatives, jets.data(), scratch.data());
      for (int c = 0; c < 3; ++c) {
        for (int d = 0; d < derivatives; ++d) {
          for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
              // 16 products of numbers of size 1 to 10.
              EXPECT_NEAR(jets[(c * derivatives + d) * kernel.samples() + j * width + i],
                          dense(d * table.samples + j * n + i, c), 1e-13);
            }
          }
        }
      }
    }
  }
}

TEST(RegularKernel, weighs_its_samples_as_the_tensor_rule_and_padding_by_zero) {
  for (int n = 1; n <= 9; ++n) {
    const RegularKernel kernel(n);
    const std::vector<Sample> rule = tensor_rule(n);
    const int width = kernel.samples() / n;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < width; ++i) {
        EXPECT_EQ(kernel.weights()[j * width + i], i < n ? rule[j * n + i].weight : 0);
      }
    }
  }
}

TEST(RegularKernel, pull_back_is_the_transpose_and_adds) {
  for (const int n : {1, 3, 4, 5, 8}) {
    const RegularKernel kernel(n);
    std::vector<double> scratch(kernel.scratch_size());
    for (const int derivatives : kDerivativeCounts) {
      Random random(n);
      const Points x = random.points(16), start = random.points(16);
      const int size = 3 * derivatives * kernel.samples();
      Eigen::VectorXd jets(size);
      const Eigen::VectorXd w = random.matrix<Eigen::VectorXd>(size, 1);
      kernel.jets(x.data(), derivatives, jets.data(), scratch.data());
      Points gradient = start;
      kernel.pull_back(w.data(), derivatives, gradient.data(), scratch.data());
      EXPECT_NEAR(jets.dot(w), (gradient - start).cwiseProduct(x).sum(), 1e-12 * jets.norm() * w.norm());
    }
  }
}

}  // namespace
}  // namespace umbilic::test
