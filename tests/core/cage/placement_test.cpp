// SPDX-License-Identifier: MIT
/// \file
/// Unit coordinates: of what size, how exact, and back.
#include "cage/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cage/generate.h"

namespace umbilic::test {
namespace {

Points points_of(std::string_view name) { return generate_cage(name)->vertices; }

double longest_side(const Points& points) {
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

TEST(Placement, of_a_cage_scaled_by_a_power_of_two_gives_the_same_unit_coordinates) {
  for (const CageName& name : cage_names()) {
    const Points points = points_of(name.name);
    const Points unit = placement_of(points).to_unit(points);
    for (const int power : {-700, -300, -1, 1, 300, 900}) {
      const Points scaled = points.unaryExpr([&](double x) { return std::ldexp(x, power); });
      EXPECT_EQ(placement_of(scaled).to_unit(scaled), unit) << name.name << " times 2^" << power;
      EXPECT_EQ(placement_of(scaled).back(unit), scaled) << name.name << " times 2^" << power;
    }
  }
}

TEST(Placement, makes_the_longest_side_at_least_2_and_less_than_4) {
  const Points cube = points_of("cube");
  for (double size = 1e-290; size < 1e290; size *= 37) {
    for (const double offset : {0., 1., 1e3, 1e12}) {
      const Points points = size * (cube.array() + offset).matrix();
      const double side = longest_side(placement_of(points).to_unit(points));
      EXPECT_GE(side, 2 * (1 - 1e-3)) << size << " " << offset;  // which rounding leaves of a side at 1e12 sides
      EXPECT_LE(side, 4) << size << " " << offset;
    }
  }
}

TEST(Placement, leaves_cages_about_the_origin_where_they_are) {
  for (const CageName& name : cage_names()) EXPECT_TRUE(placement_of(points_of(name.name)).is_centred()) << name.name;
  const Points corner = (points_of("cube").array() + 1).matrix();
  EXPECT_TRUE(placement_of(corner).is_centred()) << "[0, 2]^3";
  EXPECT_FALSE(placement_of((corner.array() + 8).matrix()).is_centred());
}

TEST(Placement, moves_a_distant_cage_to_the_origin_without_any_rounding) {
  // Binary fractions that 1e6 and 1e9 leave room for in a double.
  const Points points = (points_of("two-3") * 0x1p20).array().round() / 0x1p20;
  for (const double offset : {1e6, -1e6, 1e9}) {
    const Points distant = (points.array() + offset).matrix();
    const Placement placement = placement_of(distant);
    const Points unit = placement.to_unit(distant);
    EXPECT_LE(unit.cwiseAbs().maxCoeff(), 4);
    EXPECT_EQ(placement.back(unit), distant);
    const Points differences = unit.rowwise() - unit.row(0), expected = points.rowwise() - points.row(0);
    EXPECT_EQ(differences * std::ldexp(1., placement.exponent), expected) << offset;
  }
}

TEST(Placement, of_the_largest_doubles_does_not_overflow) {
  constexpr double kMax = std::numeric_limits<double>::max();
  Points points(2, 3);
  points << -kMax, kMax, 0, kMax, kMax, -kMax;
  const Placement placement = placement_of(points);
  EXPECT_TRUE(placement.to_unit(points).allFinite());
  EXPECT_EQ(placement.back(placement.to_unit(points)), points);
}

TEST(Placement, of_points_that_coincide_is_the_identity) {
  const Points points = Points::Constant(4, 3, 1e5);
  EXPECT_EQ(placement_of(points).to_unit(points), points);
  EXPECT_EQ(placement_of(Points(0, 3)).exponent, 0);
}

TEST(Placement, knows_what_rounding_leaves_open) {
  Points points(3, 3);
  points << 0x1p30, 0, 1, 0x1p30 + 4, 3, 2, 0x1p30, 4, -0x1.8p30;
  const Placement placement = placement_of(points);
  const Points rounding = placement.rounding(points) * std::ldexp(1., placement.exponent);
  EXPECT_EQ(rounding(0, 0), 0x1p-23);
  EXPECT_EQ(rounding(0, 1), 0);
  EXPECT_EQ(rounding(0, 2), 0x1p-53);
  EXPECT_EQ(rounding(2, 2), 0x1p-23);
  EXPECT_EQ(points(0, 0) + 0.9 * rounding(0, 0), points(0, 0)) << "less than half a unit is lost";
  EXPECT_GT(points(0, 0) + 1.1 * rounding(0, 0), points(0, 0));
}

}  // namespace
}  // namespace umbilic::test
