// SPDX-License-Identifier: MIT
/// \file
/// Limits of sequences whose limits are known, and sequences that have none to be believed.
#include "driver/extrapolate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbilic {
namespace {

/// E + C h^p for h = 1, 1/2, 1/4, ….
std::vector<LevelEnergy> sequence(double limit, double constant, double order, int count = 3) {
  std::vector<LevelEnergy> levels;
  for (int i = 0; i < count; ++i) levels.push_back({limit + constant * std::exp2(-order * i), 1e-9, 100, true});
  return levels;
}

TEST(Extrapolate, keeps_the_true_limit_of_a_power_law_inside_its_error) {
  for (const bool third_order : {false, true}) {
    for (const double order : {1.6, 2.0, 3.0, 4.0, 5.5}) {
      for (const double constant : {1e-3, 1.0, 50.0}) {
        const LimitReport limit = extrapolate(sequence(100, constant, order), third_order);
        ASSERT_EQ(limit.status, LimitStatus::kConverging) << order;
        EXPECT_NEAR(limit.order, order, 1e-3);
        EXPECT_LE(std::abs(limit.energy - 100), limit.error) << order;
        const double decrease = constant * (std::exp2(-order) - std::exp2(-2 * order));
        EXPECT_LE(limit.error, decrease + 1e-8) << "of the size of the last decrease";
      }
    }
  }
}

TEST(Extrapolate, has_an_error_that_reaches_the_limit_of_every_order_from_1_on) {
  // From E3 without any further decrease to E3 - d2, where each level halves the decrease.
  for (const bool third_order : {false, true}) {
    for (const double order : {1.6, 2.0, 4.0, 6.0}) {
      const auto levels = sequence(100, 1, order);
      const double last = levels[2].energy, decrease = levels[1].energy - last;
      const LimitReport limit = extrapolate(levels, third_order);
      EXPECT_LE(limit.energy - limit.error, last - decrease);
      EXPECT_GE(limit.energy + limit.error, last);
    }
  }
}

TEST(Extrapolate, is_exact_for_the_elements_own_order) {
  EXPECT_NEAR(extrapolate(sequence(100, 1, 2), true).energy, 100, 1e-12);
  EXPECT_NEAR(extrapolate(sequence(100, 1, 4), false).energy, 100, 1e-12);
  EXPECT_NEAR(extrapolate(sequence(100, 1, 3), false).energy, 100, 1e-12) << "a lower order is the observed one";
}

TEST(Extrapolate, trusts_no_order_above_the_elements) {
  // Faster sequences are extrapolated as if slower ones followed: below their last energy, above that less its
  // decrease.
  const auto levels = sequence(100, 1, 6);
  const LimitReport limit = extrapolate(levels, true);
  const double last = levels[2].energy, decrease = levels[1].energy - last;
  EXPECT_NEAR(limit.energy, last - decrease / 3, 1e-12);
  EXPECT_NEAR(limit.order, 6, 1e-6);
}

TEST(Extrapolate, sees_the_last_three_levels_alone) {
  auto levels = sequence(100, 1, 2);
  const LimitReport three = extrapolate(levels, true);
  levels.insert(levels.begin(), LevelEnergy{3, 1e9, 1e9, false});
  const LimitReport four = extrapolate(levels, true);
  EXPECT_EQ(four.status, three.status);
  EXPECT_EQ(four.energy, three.energy);
  EXPECT_EQ(four.error, three.error);
}

TEST(Extrapolate, adds_what_minimization_and_quadrature_leave_of_the_last_two_levels) {
  auto levels = sequence(100, 1, 2);
  const double exact = extrapolate(levels, true).error;
  levels[0].uncertainty = 7;
  levels[1].uncertainty += 1e-3;
  levels[2].uncertainty += 2e-3;
  EXPECT_NEAR(extrapolate(levels, true).error, exact + 3e-3, 1e-12);
}

void expect_refused(const std::vector<LevelEnergy>& levels, LimitStatus status, bool third_order = true) {
  const LimitReport limit = extrapolate(levels, third_order);
  EXPECT_EQ(name_of(limit.status), name_of(status));
  if (!levels.empty()) {
    EXPECT_EQ(limit.energy, levels.back().energy) << "the last energy stands in for the limit";
  }
  EXPECT_TRUE(std::isnan(limit.error));
}

TEST(Extrapolate, refuses_fewer_than_three_levels) {
  for (int count = 0; count < 3; ++count) expect_refused(sequence(1, 1, 2, count), LimitStatus::kTooFewLevels);
  EXPECT_TRUE(std::isnan(extrapolate({}, true).energy));
}

TEST(Extrapolate, refuses_energies_that_are_not_the_surfaces_however_few_there_are) {
  for (int count = 1; count < 4; ++count) {
    auto levels = sequence(1, 1, 2, count);
    levels.back().whole = false;
    expect_refused(levels, LimitStatus::kNotWhole);
  }
}

TEST(Extrapolate, refuses_levels_that_did_not_converge_whatever_their_energies) {
  for (int i = 0; i < 3; ++i) {
    auto levels = sequence(100, 1, 2);
    levels[i].minimized = false;
    expect_refused(levels, LimitStatus::kNotMinimized);
    EXPECT_NEAR(extrapolate(levels, true).order, 2, 1e-6) << "what was observed is told";
  }
}

TEST(Extrapolate, refuses_energies_that_rise_or_fall_ever_faster_or_slowly) {
  expect_refused({{3, 0, 100, true}, {2, 0, 100, true}, {2.5, 0, 100, true}}, LimitStatus::kNotConverging);
  expect_refused({{2, 0, 100, true}, {3, 0, 100, true}, {2.5, 0, 100, true}}, LimitStatus::kNotConverging);
  expect_refused({{1, 0, 100, true}, {2, 0, 100, true}, {3, 0, 100, true}}, LimitStatus::kNotConverging);
  for (const double order : {-1.0, 0.1, 1.0, 1.45}) {
    expect_refused(sequence(100, order < 0 ? -1 : 1, order), LimitStatus::kNotConverging);
  }
}

TEST(Extrapolate, refuses_third_order_energies_of_surfaces_whose_changes_do_not_halve) {
  auto levels = sequence(100, 1, 2);
  const auto with_bending = [&](double first, double second, double third) {
    levels[0].bending = first;
    levels[1].bending = second;
    levels[2].bending = third;
    return levels;
  };
  expect_refused(with_bending(142, 178, 237), LimitStatus::kNotConverging);
  EXPECT_EQ(extrapolate(levels, false).status, LimitStatus::kConverging) << "bending itself shows what it does";
  expect_refused(with_bending(100, 110, 104), LimitStatus::kNotConverging);
  expect_refused(with_bending(100, 110, 116), LimitStatus::kNotConverging);
  EXPECT_EQ(extrapolate(with_bending(100, 110, 115), true).status, LimitStatus::kConverging);
  EXPECT_EQ(extrapolate(with_bending(100, 100, 100.9), true).status, LimitStatus::kConverging) << "less than a percent";
}

TEST(Extrapolate, takes_levels_that_agree_within_their_uncertainty_as_the_limit) {
  for (const double change : {0.0, 1e-7, -1e-7}) {
    const std::vector<LevelEnergy> levels{{5, 1e-6, 100, true}, {5, 1e-6, 100, true}, {5 + change, 1e-6, 100, true}};
    const LimitReport limit = extrapolate(levels, true);
    EXPECT_EQ(limit.status, LimitStatus::kConverging);
    EXPECT_EQ(limit.energy, 5 + change);
    EXPECT_NEAR(limit.error, 2e-6 + std::abs(change), 1e-15);
    EXPECT_TRUE(std::isnan(limit.order));
  }
}

}  // namespace
}  // namespace umbilic
