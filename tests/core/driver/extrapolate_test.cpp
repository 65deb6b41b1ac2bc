// SPDX-License-Identifier: MIT
/// \file
/// Limits of sequences whose limits are known, and sequences that have none to be believed.
#include "driver/extrapolate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
        const double before = constant * (1 - std::exp2(-order)), decrease = before * std::exp2(-order);
        EXPECT_LE(limit.error, std::max(decrease, before / (third_order ? 12 : 240)) + 1e-8)
            << "of the size of the last decrease, or of what the elements leave of the one before";
      }
    }
  }
}

void expect_interval(const LimitReport& limit, double last, double most) {
  EXPECT_LE(limit.energy - limit.error, last - most + 1e-12);
  EXPECT_GE(limit.energy + limit.error, last);
}

TEST(Extrapolate, has_an_error_that_reaches_the_limit_of_every_order_from_1_on_where_the_elements_order_was_not_seen) {
  // From E3 without any further decrease to E3 - d2, where each level halves the decrease.
  const auto expect_reached = [](double order, bool third_order) {
    const auto levels = sequence(100, 1, order);
    const double last = levels[2].energy, decrease = levels[1].energy - last;
    expect_interval(extrapolate(levels, third_order), last, decrease);
  };
  for (const double order : {1.6, 2.0, 2.5, 4.0, 6.0}) expect_reached(order, true);
  for (const double order : {1.6, 2.0, 6.0}) expect_reached(order, false);
}

TEST(Extrapolate, takes_the_true_order_for_lower_than_the_elements_by_one_more_than_the_observed_is_off) {
  for (const auto& [order, least] : {std::pair{2.5, 1.5}, {3.0, 2.0}, {3.7, 2.7}, {4.0, 3.0}, {4.5, 2.5}, {5.5, 1.5}}) {
    const auto levels = sequence(100, 1, order);
    const double last = levels[2].energy, decrease = levels[1].energy - last;
    const double most = decrease / (std::exp2(least) - 1);
    const LimitReport limit = extrapolate(levels, false);
    expect_interval(limit, last, most);
    const double correction = last - limit.energy;
    EXPECT_NEAR(limit.error, std::max(most - correction, correction), 1e-8) << order << " and no wider";
  }
}

TEST(Extrapolate, knows_what_extraordinary_vertices_leave_of_second_order) {
  // E + C h^4 + D h^2: curvature is wrong on an area that falls as h^2.
  for (const double vertices : {-0.1, -0.01, 0.0, 0.01, 0.1, 1.0, 10.0, 1000.0}) {
    std::vector<LevelEnergy> levels;
    for (const double h : {1.0, 0.5, 0.25}) levels.push_back({100 + std::pow(h, 4) + vertices * h * h, 0, 100, true});
    const LimitReport limit = extrapolate(levels, false);
    ASSERT_EQ(limit.status, LimitStatus::kConverging);
    EXPECT_LE(std::abs(limit.energy - 100), limit.error) << vertices;
  }
}

TEST(Extrapolate, is_exact_for_the_elements_own_order) {
  EXPECT_NEAR(extrapolate(sequence(100, 1, 2), true).energy, 100, 1e-12);
  EXPECT_NEAR(extrapolate(sequence(100, 1, 4), false).energy, 100, 1e-12);
  EXPECT_NEAR(extrapolate(sequence(100, 1, 3), false).energy, 100, 1e-12) << "a lower order is the observed one";
}

TEST(Extrapolate, trusts_no_order_above_the_elements) {
  // Somewhat faster sequences are extrapolated as if slower ones followed.
  const auto levels = sequence(100, 1, 2.5);
  const LimitReport limit = extrapolate(levels, true);
  const double last = levels[2].energy, decrease = levels[1].energy - last;
  EXPECT_NEAR(limit.energy, last - decrease / 3, 1e-12);
  EXPECT_NEAR(limit.order, 2.5, 1e-6);
}

TEST(Extrapolate, expects_of_much_faster_sequences_what_the_elements_leave_of_the_decrease_before) {
  // Were d1 all of an error C h^q, d1 / (2^q (2^q - 1)) would be left after E3, however little the last level gained.
  for (const bool third_order : {false, true}) {
    const double left = third_order ? 1.0 : 0.05;
    for (const double gained : {0.0, 1e-12, 1e-3, 0.09}) {
      const std::vector<LevelEnergy> levels{{100, 1e-9, 50, true}, {88, 1e-9, 50, true}, {88 - gained, 1e-9, 50, true}};
      const LimitReport limit = extrapolate(levels, third_order);
      ASSERT_EQ(limit.status, LimitStatus::kConverging);
      EXPECT_NEAR(limit.energy, 88 - gained - left, 1e-9);
      EXPECT_NEAR(limit.error, left, 1e-8) << "from nothing to twice as much";
      EXPECT_EQ(std::isnan(limit.order), gained < 1e-9);
    }
  }
}

/// Levels whose surfaces have settled, with no uncertainty.
std::vector<LevelEnergy> settled(const std::vector<double>& energies) {
  std::vector<LevelEnergy> levels;
  for (const double energy : energies) levels.push_back({energy, 0, 100, true});
  return levels;
}

struct Measured {
  std::vector<double> levels;
  double limit;  ///< of the other family, with levels up to 5
};

TEST(Extrapolate, does_not_exclude_what_another_family_of_cages_converges_to) {
  // mvs_cross from hub cages, levels 2 to 4, and the limits of the flag cages at levels 3 to 5.
  for (const auto& [levels, other] : {Measured{{4521.493, 4000.538, 3954.622}, 3919},      // two-3
                                      Measured{{8948.626, 7845.853, 7779.209}, 7698},      // tetrahedron
                                      Measured{{21277.94, 18007.94, 17753.56}, 17481},     // cube
                                      Measured{{92579.25, 72848.10, 71691.31}, 69965}}) {  // dodecahedron
    const LimitReport limit = extrapolate(settled(levels), true);
    ASSERT_EQ(limit.status, LimitStatus::kConverging);
    EXPECT_GT(limit.order, 3.4);
    EXPECT_LT(std::abs(limit.energy - other), limit.error) << other;
    EXPECT_LT(limit.error, 0.03 * other);
  }
}

TEST(Extrapolate, believes_no_order_that_falls_by_more_than_is_left_of_it) {
  // mvs_cross of two-3 from the hub cage, levels 2 to 5: orders 3.5 and 1.7, and a limit that the flag cage puts at
  // 3919.
  const std::vector<double> energies{4521.493, 4000.538, 3954.615, 3940.173};
  const LimitReport limit = extrapolate(settled(energies), true);
  EXPECT_NEAR(limit.energy, 3940.173 - (4521.493 - 4000.538) / 48, 1e-3);
  EXPECT_LT(std::abs(limit.energy - 3919), limit.error);
  const LimitReport without = extrapolate(settled({energies.begin() + 1, energies.end()}), true);
  EXPECT_GT(std::abs(without.energy - 3919), without.error) << "three levels cannot tell";
}

TEST(Extrapolate, sees_the_last_three_levels_alone_where_the_order_keeps) {
  auto levels = sequence(100, 1, 2);
  const LimitReport three = extrapolate(levels, true);
  const auto expect_same = [&](const LevelEnergy& before) {
    auto four = levels;
    four.insert(four.begin(), before);
    const LimitReport limit = extrapolate(four, true);
    EXPECT_EQ(limit.status, three.status);
    EXPECT_EQ(limit.energy, three.energy);
    EXPECT_EQ(limit.error, three.error);
  };
  expect_same({3, 1e9, 1e9, false});
  expect_same({1e9, 0, 100, false});
  expect_same({3, 0, 100, true});
  expect_same({levels[0].energy + 15 * (levels[0].energy - levels[1].energy), 0, 100, true});
}

TEST(Extrapolate, takes_an_order_that_was_observed_twice_for_a_lower_bound_of_the_order) {
  for (const double order : {1.6, 2.0, 2.3}) {
    const auto levels = sequence(100, 1, order, 4);
    const LimitReport four = extrapolate(levels, true);
    const LimitReport three = extrapolate({levels.begin() + 1, levels.end()}, true);
    const double last = levels[3].energy, decrease = levels[2].energy - last;
    EXPECT_EQ(four.energy, three.energy);
    EXPECT_LE(std::abs(four.energy - 100), four.error) << order;
    EXPECT_LE(four.energy - four.error, last - decrease / (std::exp2(1.5) - 1) + 1e-12);
    EXPECT_GE(four.energy + four.error, last);
    EXPECT_LT(four.error, three.error) << "where one order alone has been seen";
  }
}

TEST(Extrapolate, tells_whether_the_caps_widened_with_the_last_level) {
  auto levels = sequence(100, 1, 2);
  EXPECT_TRUE(extrapolate(levels, true).caps_included) << "without caps";
  const auto with = [&](int before, int last, bool third_order) {
    levels[1].cap_rings = before;
    levels[2].cap_rings = last;
    return extrapolate(levels, third_order).caps_included;
  };
  EXPECT_TRUE(with(4, 8, true));
  EXPECT_FALSE(with(4, 4, true));
  EXPECT_FALSE(with(16, 16, true));
  EXPECT_TRUE(with(4, 4, false)) << "which does not depend on caps";
  levels.pop_back();
  EXPECT_FALSE(extrapolate(levels, true).caps_included) << "without a limit";
}

TEST(Extrapolate, takes_the_difference_to_narrower_caps_into_the_bar) {
  auto levels = sequence(100, 1, 2);
  levels[1].cap_rings = levels[2].cap_rings = 4;
  const LimitReport without = extrapolate(levels, true);
  for (const double difference : {0.5, -0.25}) {
    levels[1].with_narrower_caps = levels[1].energy + difference;
    const LimitReport with = extrapolate(levels, true);
    EXPECT_TRUE(with.caps_included);
    EXPECT_NEAR(with.energy, without.energy - difference / 2, 1e-12);
    EXPECT_NEAR(with.error, without.error + std::abs(difference) / 2, 1e-12);
  }
  levels[2].cap_rings = 8;
  EXPECT_EQ(extrapolate(levels, true).error, without.error) << "where the levels know it";
}

TEST(Extrapolate, adds_what_minimization_and_quadrature_leave_of_the_last_two_levels) {
  auto levels = sequence(100, 1, 2);
  const double exact = extrapolate(levels, true).error;
  levels[0].uncertainty = 7;
  levels[1].uncertainty += 1e-3;
  levels[2].uncertainty += 2e-3;
  EXPECT_NEAR(extrapolate(levels, true).error, exact + 3e-3, 1e-12);
}

double least_energy(const std::vector<LevelEnergy>& levels) {
  double least = std::numeric_limits<double>::infinity();
  for (const LevelEnergy& level : levels) {
    if (level.resolved) least = std::min(least, level.energy);
  }
  return std::isfinite(least) ? least : levels.back().energy;
}

void expect_refused(const std::vector<LevelEnergy>& levels, LimitStatus status, bool third_order = true) {
  const LimitReport limit = extrapolate(levels, third_order);
  EXPECT_EQ(name_of(limit.status), name_of(status));
  if (!levels.empty()) {
    EXPECT_EQ(limit.energy, least_energy(levels)) << "the least energy stands in for the limit";
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
    levels.back().resolved = false;
    expect_refused(levels, LimitStatus::kNotResolved);
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

TEST(Extrapolate, moves_a_limit_below_the_bound_up_to_it_and_keeps_the_upper_end) {
  // mvs of a thin torus, whose infimum is 0.
  const std::vector<LevelEnergy> levels{{378.919, 0, 100, true}, {66.270, 0, 100, true}, {14.410, 0, 100, true}};
  const LimitReport free = extrapolate(levels, true, -1e9), limit = extrapolate(levels, true, 0);
  ASSERT_EQ(limit.status, LimitStatus::kConverging);
  EXPECT_LT(free.energy, 0);
  EXPECT_EQ(limit.energy, 0);
  EXPECT_EQ(limit.lower, 0);
  EXPECT_EQ(limit.order, free.order);
  EXPECT_NEAR(limit.energy + limit.error, free.energy + free.error, 1e-12);
}

TEST(Extrapolate, cuts_off_what_a_bar_has_below_the_bound) {
  const auto levels = sequence(100, 1, 2);
  const LimitReport free = extrapolate(levels, true);
  EXPECT_EQ(free.lower, free.energy - free.error);
  const double bound = free.energy - free.error / 3;
  const LimitReport limit = extrapolate(levels, true, bound);
  EXPECT_EQ(limit.energy, free.energy);
  EXPECT_EQ(limit.error, free.error);
  EXPECT_EQ(limit.lower, bound);
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
