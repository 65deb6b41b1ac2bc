// SPDX-License-Identifier: MIT
/// \file
/// Dual numbers with several tangents against derivatives that are known.
#include "energy/kernels/dual_number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbilic::test {
namespace {

using Number = DualNumber<double, 2>;

/// x and y, which the two tangents belong to.
Number variable(double value, int tangent) {
  Number number(value);
  number.tangent[tangent] = 1;
  return number;
}

void expect(const Number& number, double value, double by_x, double by_y) {
  EXPECT_DOUBLE_EQ(number.value, value);
  EXPECT_DOUBLE_EQ(number.tangent[0], by_x);
  EXPECT_DOUBLE_EQ(number.tangent[1], by_y);
}

constexpr double kX = 1.75, kY = -0.5;

TEST(DualNumber, obeys_the_rules_of_sum_product_and_quotient) {
  const Number x = variable(kX, 0), y = variable(kY, 1);
  expect(x + y, kX + kY, 1, 1);
  expect(x - y, kX - kY, 1, -1);
  expect(-x, -kX, -1, 0);
  expect(x * y, kX * kY, kY, kX);
  expect(x / y, kX / kY, 1 / kY, -kX / (kY * kY));
  expect(x * x * x, kX * kX * kX, 3 * kX * kX, 0);
}

TEST(DualNumber, takes_constants_as_numbers_without_tangents) {
  const Number x = variable(kX, 0), constant(3.0);
  expect(constant, 3, 0, 0);
  expect(x + 2.0, kX + 2, 1, 0);
  expect(2.0 + x, kX + 2, 1, 0);
  expect(2.0 * x, 2 * kX, 2, 0);
  expect(x * 2.0, 2 * kX, 2, 0);
  expect(2.0 / x, 2 / kX, -2 / (kX * kX), 0);
}

TEST(DualNumber, adds_and_subtracts_in_place) {
  Number sum = variable(kX, 0);
  sum += variable(kY, 1);
  expect(sum, kX + kY, 1, 1);
  sum -= variable(kX, 0);
  expect(sum, kY, 0, 1);
}

TEST(DualNumber, obeys_the_chain_rule_for_the_square_root) {
  const Number x = variable(kX, 0), y = variable(kY, 1);
  const double root = std::sqrt(kX * kX + kY * kY);
  expect(sqrt(x * x + y * y), root, kX / root, kY / root);
}

TEST(DualNumber, over_lanes_gives_the_numbers_of_each_lane) {
  const auto f = [](const auto& x, const auto& y) { return sqrt(x * x + 2.0) / (y - x) + 3.0 / y; };
  DualNumber<Lanes, 2> x, y;
  for (int i = 0; i < kLaneCount; ++i) {
    x.value[i] = kX + i;
    y.value[i] = kY - 0.25 * i;
  }
  x.tangent[0] = splat(1.0);
  y.tangent[1] = splat(1.0);
  const DualNumber<Lanes, 2> together = f(x, y);
  for (int i = 0; i < kLaneCount; ++i) {
    const Number alone = f(variable(kX + i, 0), variable(kY - 0.25 * i, 1));
    EXPECT_EQ(together.value[i], alone.value);
    for (int k = 0; k < 2; ++k) EXPECT_EQ(together.tangent[k][i], alone.tangent[k]);
  }
}

}  // namespace
}  // namespace umbilic::test
