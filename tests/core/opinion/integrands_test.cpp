// SPDX-License-Identifier: MIT
/// \file
/// The integrands of a second opinion on surfaces in closed form.
#include "opinion/integrands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace umbilic::opinion {
namespace {

/// The densities by their names, with the area element divided out.
std::map<std::string, double> densities(const TaylorPoint& x) {
  const Quantities values = integrands(x);
  std::map<std::string, double> result;
  for (std::size_t q = 0; q < values.size(); ++q) result[std::string(kQuantities[q].name)] = values[q] / values[0];
  return result;
}

/// Parameters that are neither orthogonal nor affine.
struct Parameters {
  Taylor u, v;
};
Parameters skewed(double u, double v) {
  const Taylor s = Taylor::along_s(0, 1), t = Taylor::along_t(0, 1);
  return {u + 0.8 * s - 0.5 * t + 0.3 * s * s + 0.2 * s * t * t, v + 0.3 * s + 1.1 * t - 0.4 * s * t + 0.1 * s * s * s};
}

TEST(Integrands, of_a_sphere_have_no_third_order_and_positive_curvatures) {
  const auto [u, v] = skewed(0.7, 0.4);
  const double r = 1.7;
  const auto found = densities({r * cos(v) * cos(u), r * cos(v) * sin(u), r * sin(v)});
  EXPECT_NEAR(found.at("gaussian"), 1 / (r * r), 1e-14);
  EXPECT_NEAR(found.at("bending"), 2 / (r * r), 1e-14);
  EXPECT_NEAR(found.at("willmore"), 1 / (r * r), 1e-14);
  for (const Quantity& quantity : kQuantities) {
    if (quantity.third_order) {
      EXPECT_NEAR(found.at(std::string(quantity.name)), 0, 1e-26) << quantity.name;
    }
  }
}

TEST(Integrands, of_a_torus_are_those_of_the_one_curvature_that_varies) {
  const double major = 1.3, minor = 0.6;
  for (double at = -3; at < 3; at += 0.7) {
    const auto [u, v] = skewed(0.4, at);
    const Taylor radius = major + minor * cos(v);
    const auto found = densities({radius * cos(u), radius * sin(u), minor * sin(v)});
    const double w = major + minor * std::cos(at), k1 = 1 / minor, k2 = std::cos(at) / w;
    const double slope = -major * std::sin(at) / (w * w * minor), square = slope * slope;
    const double tolerance = 1e-12 * (1 + square) * 10;
    EXPECT_NEAR(found.at("gaussian"), k1 * k2, tolerance);
    EXPECT_NEAR(found.at("mvs"), 0, tolerance);
    EXPECT_NEAR(found.at("mvs_cross"), square, tolerance);
    EXPECT_NEAR(found.at("mehlum_tarrou"), 9 / 16. * square, tolerance);
    EXPECT_NEAR(found.at("second_form_variation"), 3 * square, tolerance);
    EXPECT_NEAR(found.at("mean_curvature_variation"), square, tolerance);
    EXPECT_NEAR(found.at("curvedness_variation"), k2 * k2 * square, tolerance);
    // C_122 = slope and its permutations, in principal directions with curvatures k1 (around the tube) and k2.
    EXPECT_NEAR(found.at("gradient_form"), k1 * square, tolerance);
    EXPECT_NEAR(found.at("variation_form"), (k1 + 2 * k2) * square, tolerance);
    EXPECT_NEAR(found.at("triple_form"), 3 * k1 * k2 * k2 * square, tolerance);
  }
}

TEST(Integrands, of_a_cone_change_along_its_rulings_and_turn_their_sign_with_the_side) {
  const double half_angle = 0.6, s = std::sin(half_angle), c = std::cos(half_angle);
  const auto [u, rho] = skewed(1.2, 1.5);
  const TaylorPoint cone{rho * s * cos(u), rho * s * sin(u), rho * c};
  const auto found = densities(cone), other = densities({cone[0], cone[1] * -1, cone[2]});
  const double slope = c / s / (1.5 * 1.5);
  EXPECT_NEAR(found.at("mvs"), 0, 1e-12);
  EXPECT_NEAR(found.at("mvs_cross"), slope * slope, 1e-12);
  EXPECT_NEAR(found.at("variation_form"), -other.at("variation_form"), 1e-12);
  EXPECT_GT(std::abs(found.at("variation_form")), 0.1);
}

}  // namespace
}  // namespace umbilic::opinion
