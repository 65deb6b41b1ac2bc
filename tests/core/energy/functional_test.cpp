// SPDX-License-Identifier: MIT
/// \file
/// Names of functionals and weights as users write them.
#include "energy/functional.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace umbilic::test {
namespace {

std::string error_of(std::string_view text) {
  const Result<Weights> weights = parse_weights(text);
  return weights ? "" : weights.error().message;
}

TEST(Functional, each_name_weighs_its_own_functional) {
  for (int f = 0; f < kFunctionalCount; ++f) {
    Weights expected{};
    expected[f] = 1;
    EXPECT_EQ(weights_of(kFunctionalNames[f]).value(), expected);
  }
}

TEST(Functional, an_unknown_name_is_named_and_the_known_ones_are_listed) {
  EXPECT_EQ(weights_of("bendin").error().message,
            "unknown functional \"bendin\"; known are bending, willmore, mvs, mvs_cross, mehlum_tarrou, "
            "second_form_variation, mean_curvature_variation, curvedness_variation");
  EXPECT_FALSE(weights_of("").ok());
  EXPECT_FALSE(weights_of("MVS").ok());
}

TEST(ParseWeights, reads_the_papers_blend) {
  const Weights weights = parse_weights("bending=0.95,mvs_cross=0.05").value();
  EXPECT_EQ(weights, (Weights{0.95, 0, 0, 0.05, 0, 0}));
  EXPECT_EQ(parse_weights("mvs=1e-3").value()[kMvs], 1e-3);
}

TEST(ParseWeights, adds_what_stands_twice) {
  EXPECT_EQ(parse_weights("mvs=1,mvs=2,bending=0").value(), (Weights{0, 0, 3, 0, 0, 0}));
}

TEST(ParseWeights, names_the_part_at_fault) {
  EXPECT_EQ(error_of("bending"), "weight \"bending\": expected NAME=NUMBER");
  EXPECT_EQ(error_of("mvs=1,bending=x"), "weight \"bending=x\": \"x\" is not a finite number >= 0");
  EXPECT_EQ(error_of("mvs=-1"), "weight \"mvs=-1\": \"-1\" is not a finite number >= 0");
  EXPECT_EQ(error_of("mvs=1e999"), "weight \"mvs=1e999\": \"1e999\" is not a finite number >= 0");
  EXPECT_EQ(error_of("mvs=nan"), "weight \"mvs=nan\": \"nan\" is not a finite number >= 0");
  EXPECT_EQ(error_of("mvs=inf"), "weight \"mvs=inf\": \"inf\" is not a finite number >= 0");
  EXPECT_EQ(error_of("mvs=1 "), "weight \"mvs=1 \": \"1 \" is not a finite number >= 0");
  EXPECT_EQ(error_of("mvs="), "weight \"mvs=\": \"\" is not a finite number >= 0");
  EXPECT_NE(error_of("volume=1").find("unknown functional \"volume\""), std::string::npos);
  EXPECT_NE(error_of("mvs=1,,bending=1"), "");
}

TEST(ParseWeights, refuses_weights_that_are_all_zero) {
  EXPECT_EQ(error_of(""), "all weights are zero");
  EXPECT_EQ(error_of("mvs=0,bending=0"), "all weights are zero");
}

TEST(Usable, refuses_what_is_negative_or_not_finite_and_names_the_functional) {
  Error error;
  EXPECT_TRUE(usable({0, 0, 0, 0, 0, 1e-300}, error));
  EXPECT_FALSE(usable({1, 0, -1, 0, 0, 0}, error));
  EXPECT_EQ(error.message, "weight of mvs is not a finite number >= 0");
  EXPECT_FALSE(usable({std::numeric_limits<double>::infinity(), 0, 0, 0, 0, 0}, error));
  EXPECT_EQ(error.message, "weight of bending is not a finite number >= 0");
  EXPECT_FALSE(usable({0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0}, error));
}

TEST(Functional, third_order_begins_with_mvs) {
  EXPECT_FALSE(is_third_order(kBending));
  EXPECT_FALSE(is_third_order(kWillmore));
  for (int f = kMvs; f < kFunctionalCount; ++f) EXPECT_TRUE(is_third_order(f)) << kFunctionalNames[f];
}

TEST(Functional, has_the_power_of_the_area_that_its_order_asks_and_one_has_the_square) {
  for (int f = 0; f < kFunctionalCount; ++f) {
    const int expected = f == kCurvednessVariation ? 2 : is_third_order(f) ? 1 : 0;
    EXPECT_EQ(area_power(f), expected) << kFunctionalNames[f];
    Weights weights{};
    weights[f] = 1;
    for (int p = 0; p < kAreaPowerCount; ++p) EXPECT_EQ(area_powers(weights).has[p], p == expected);
    EXPECT_EQ(third_order(weights), is_third_order(f));
  }
  EXPECT_EQ(area_to_the(0, 0.3), 1);
  EXPECT_EQ(area_to_the(1, 0.3), 0.3);
  EXPECT_EQ(area_to_the(2, 0.5), 0.25);
}

}  // namespace
}  // namespace umbilic::test
