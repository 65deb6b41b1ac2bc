// SPDX-License-Identifier: MIT
/// \file
/// The line search on the test functions of Moré & Thuente 1994, section 5, and where functions end.
#include "solve/line_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace umbilic::test {
namespace {

struct Outcome {
  LineSearch::Status status;
  double step;
  int evaluations;
};

using Slice = std::function<std::pair<double, double>(double)>;

Outcome search(const Slice& phi, double first_step, LineSearchOptions options) {
  const auto [value, slope] = phi(0);
  LineSearch line(value, slope, first_step, options);
  for (int i = 1;; ++i) {
    const double step = line.step();
    const auto [v, s] = phi(step);
    const LineSearch::Status status = line.update(v, s);
    if (status != LineSearch::Status::kEvaluate) return {status, step, i};
  }
}

void expect_strong_wolfe(const Slice& phi, double step, const LineSearchOptions& options) {
  const auto [value, slope] = phi(0);
  const auto [v, s] = phi(step);
  EXPECT_LE(v, value + options.decrease * step * slope);
  EXPECT_LE(std::abs(s), options.curvature * std::abs(slope));
}

std::pair<double, double> function_1(double a) {
  const double b = 2;
  return {-a / (a * a + b), (a * a - b) / ((a * a + b) * (a * a + b))};
}

std::pair<double, double> function_2(double a) {
  const double t = a + 0.004;
  return {std::pow(t, 5) - 2 * std::pow(t, 4), 5 * std::pow(t, 4) - 8 * std::pow(t, 3)};
}

TEST(LineSearch, satisfies_the_strong_wolfe_conditions_from_first_steps_over_six_orders_of_magnitude) {
  for (const Slice& phi : {Slice(function_1), Slice(function_2)}) {
    for (const double first : {1e-3, 1e-1, 1e1, 1e3}) {
      for (const double curvature : {0.1, 0.9}) {
        LineSearchOptions options;
        options.decrease = curvature / 2;
        options.decrease = std::min(options.decrease, 0.1);
        options.curvature = curvature;
        const Outcome outcome = search(phi, first, options);
        ASSERT_EQ(outcome.status, LineSearch::Status::kDone) << first << " " << curvature;
        expect_strong_wolfe(phi, outcome.step, options);
        EXPECT_LE(outcome.evaluations, 15);
      }
    }
  }
}

TEST(LineSearch, finds_the_minimum_of_a_parabola_in_two_evaluations_when_the_conditions_are_tight) {
  const Slice parabola = [](double t) { return std::pair{(t - 3) * (t - 3), 2 * (t - 3)}; };
  LineSearchOptions options;
  options.curvature = 1e-6;
  options.decrease = 1e-7;
  const Outcome outcome = search(parabola, 1, options);
  EXPECT_EQ(outcome.status, LineSearch::Status::kDone);
  EXPECT_NEAR(outcome.step, 3, 1e-5);
  EXPECT_LE(outcome.evaluations, 4);
}

TEST(LineSearch, steps_back_from_where_the_function_is_not_finite) {
  const Slice walled = [](double t) {
    if (t >= 1) return std::pair{std::numeric_limits<double>::quiet_NaN(), 0.0};
    return std::pair{-t - std::log(1 - t) * 0.1, -1 + 0.1 / (1 - t)};
  };
  const Outcome outcome = search(walled, 50, {});
  EXPECT_EQ(outcome.status, LineSearch::Status::kDone);
  expect_strong_wolfe(walled, outcome.step, {});
}

TEST(LineSearch, fails_when_the_slope_is_not_that_of_the_function) {
  const Slice lying = [](double t) { return std::pair{t, -1.0}; };
  EXPECT_EQ(search(lying, 1, {}).status, LineSearch::Status::kFailed);
}

}  // namespace
}  // namespace umbilic::test
