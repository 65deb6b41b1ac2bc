// SPDX-License-Identifier: MIT
/// \file
/// Gauss-Legendre rules against integrals in closed form.
#include "surface/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/basis_table.h"

namespace umbilic::test {
namespace {

double integral_of_power(const GaussRule& rule, int power) {
  return (rule.weights.array() * rule.nodes.array().pow(power)).sum();
}

TEST(GaussLegendre, is_exact_for_degree_2n_minus_1_and_not_for_2n) {
  for (int points = 1; points <= 20; ++points) {
    const GaussRule rule = gauss_legendre(points);
    for (int power = 0; power < 2 * points; ++power) {
      EXPECT_NEAR(integral_of_power(rule, power), 1.0 / (power + 1), 1e-15) << points << " points, degree " << power;
    }
    // The error for x^2n is n!^4 / ((2n + 1) (2n)!^2), above round-off up to ten points.
    if (points <= 10) {
      const double error = std::exp(4 * std::lgamma(points + 1) - 2 * std::lgamma(2 * points + 1)) / (2 * points + 1);
      EXPECT_NEAR(1.0 / (2 * points + 1) - integral_of_power(rule, 2 * points), error, 1e-3 * error + 1e-15);
    }
  }
}

TEST(GaussLegendre, nodes_rise_inside_the_interval_and_mirror_to_the_last_digit) {
  for (int points = 1; points <= 24; ++points) {
    const GaussRule rule = gauss_legendre(points);
    for (int i = 0; i < points; ++i) {
      EXPECT_GT(rule.nodes[i], i == 0 ? 0 : rule.nodes[i - 1]);
      EXPECT_LT(rule.nodes[i], 1);
      EXPECT_GT(rule.weights[i], 0);
      if (2 * i + 1 < points) {
        EXPECT_EQ(rule.nodes[points - 1 - i], 1 - rule.nodes[i]);
      }
      EXPECT_EQ(rule.weights[points - 1 - i], rule.weights[i]);
    }
  }
}

TEST(GradedRule, weights_sum_to_one_and_it_integrates_polynomials_exactly) {
  for (const int points : {2, 4, 7}) {
    for (const int grading : {0, 1, 3, 6}) {
      const std::vector<Sample> rule = graded_rule(points, grading);
      EXPECT_EQ(rule.size(), static_cast<std::size_t>(points * points * (3 * grading + 1)));
      double area = 0, moment = 0;
      for (const Sample& s : rule) {
        EXPECT_TRUE(s.u > 0 && s.u < 1 && s.v > 0 && s.v < 1);
        area += s.weight;
        moment += s.weight * s.u * s.u * std::pow(s.v, 3);
      }
      EXPECT_NEAR(area, 1, 1e-14);
      EXPECT_NEAR(moment, 1 / 12.0, 1e-14);  // degree 3 in each variable: two points
    }
  }
}

TEST(GradedRule, converges_for_a_singularity_at_the_origin_where_the_plain_rule_does_not) {
  // The integral of 1/r over the unit square is 2 log(1 + sqrt 2). Each split halves what the last cell misses.
  const double exact = 2 * std::asinh(1.0);
  const auto error = [&](const std::vector<Sample>& rule) {
    double sum = 0;
    for (const Sample& s : rule) sum += s.weight / std::hypot(s.u, s.v);
    return std::abs(sum - exact);
  };
  EXPECT_GT(error(tensor_rule(6)), 1e-2);
  EXPECT_NEAR(error(graded_rule(6, 6)) / error(tensor_rule(6)), std::ldexp(1.0, -6), 1e-4);
}

TEST(PadSamples, adds_copies_of_weight_zero_up_to_whole_lanes) {
  for (int count = 1; count <= 9; ++count) {
    std::vector<Sample> samples(count, {0.25, 0.5, 1});
    pad_samples(samples, 4);
    EXPECT_EQ(samples.size(), static_cast<std::size_t>((count + 3) / 4 * 4));
    double sum = 0;
    for (const Sample& s : samples) {
      sum += s.weight;
      EXPECT_EQ(s.u, 0.25);
    }
    EXPECT_EQ(sum, count);
  }
}

}  // namespace
}  // namespace umbilic::test
