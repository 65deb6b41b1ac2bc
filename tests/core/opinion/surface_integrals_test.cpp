// SPDX-License-Identifier: MIT
/// \file
/// Integrals of a second opinion against closed forms and invariance; beside the main evaluation they stand in
/// tests/core/driver/second_opinion_test.cpp.
#include "opinion/surface_integrals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "opinion/characteristic_map.h"
#include "opinion/clenshaw_curtis.h"
#include "opinion/plain_step.h"

namespace umbilic::opinion {
namespace {

using std::numbers::pi;

TEST(ClenshawCurtis, integrates_polynomials_of_its_degree) {
  const NestedRule rule = clenshaw_curtis(16);
  for (int degree = 0; degree <= 17; ++degree) {
    double fine = 0, coarse = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      fine += rule.weights[i] * std::pow(rule.nodes[i], degree);
      coarse += rule.coarse[i] * std::pow(rule.nodes[i], degree);
    }
    EXPECT_NEAR(fine, 1. / (degree + 1), 1e-15);
    if (degree <= 9) {
      EXPECT_NEAR(coarse, 1. / (degree + 1), 1e-15);
    } else if (degree >= 12) {
      EXPECT_GT(std::abs(coarse - 1. / (degree + 1)), 1e-9);
    }
  }
}

TEST(CharacteristicMap, of_valence_4_is_the_identity) {
  const CharacteristicMap map(4, 2);
  const TaylorPoint z = bicubic(map.grid(1, 0), bspline_coefficients(0.25), bspline_coefficients(0.5));
  EXPECT_NEAR(z[0].c[0], 1.25 / 2, 1e-14);
  EXPECT_NEAR(z[1].c[0], 0.5 / 2, 1e-14);
  EXPECT_NEAR(z[0].derivative(1, 0), 0.5, 1e-14);
}

TEST(CharacteristicMap, is_scaled_by_a_step) {
  for (const int valence : {3, 5, 12}) {
    const CharacteristicMap map(valence, 2);
    CornerWindow window = map.window();
    window.step();
    const double first = window.spoke(0).norm() / map.window().spoke(0).norm();
    const double c = std::cos(2 * pi / valence);
    EXPECT_NEAR(first, (5 + c + std::sqrt((9 + c) * (1 + c))) / 16, 1e-14) << valence;  // the subdominant eigenvalue
  }
}

Integrals of(const Cage& cage) {
  const PolygonMesh mesh(cage);
  return integrate({mesh, cage.vertices});
}

/// No extraordinary vertices: the surface is a spline that approaches the torus of revolution as h^4, with third
/// derivatives as h^2. The generated torus has its control net's ratio, so that the limit's is a little different;
/// the ratio is taken from area and bending, and mvs_cross must fit it.
TEST(SecondOpinionSlow, of_fine_tori_tends_to_the_closed_forms) {
  double before = 1;
  for (const int n : {12, 24}) {
    const Integrals found = of(*generate_cage("torus", {.ratio = 0.5, .major_segments = 2 * n, .minor_segments = n}));
    const double bending = found.values[2];
    double low = 0.3, high = std::numbers::sqrt2 / 2;  // bending falls with the ratio up to there
    for (int i = 0; i < 60; ++i) {
      const double a = (low + high) / 2;
      (4 * pi * pi / (a * std::sqrt(1 - a * a)) > bending ? low : high) = a;
    }
    const double cross = 8 * std::pow(pi, 4) * std::pow(1 - low * low, -1.5);
    const double off = std::abs(found.values[5] / cross - 1);
    EXPECT_LT(off, before / 3.5);
    EXPECT_NEAR(found.values[1], 0, 1e-11);
    EXPECT_NEAR(found.values[3], bending / 4, 1e-11);
    before = off;
  }
  EXPECT_LT(before, 0.04);
}

/// Refining changes nothing but which polynomial pieces are one face.
TEST(SecondOpinionSlow, is_the_same_on_every_level_of_a_surface_without_caps) {
  const Cage once = refined(*generate_cage("cube")), twice = refined(once);
  const Integrals coarse = of(once), fine = of(twice);
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    if (kQuantities[q].third_order) {
      EXPECT_TRUE(std::isnan(coarse.values[q])) << kQuantities[q].name;
    } else {
      EXPECT_NEAR(coarse.values[q], fine.values[q], 1e-9 * std::abs(fine.values[q])) << kQuantities[q].name;
    }
  }
  EXPECT_NEAR(fine.values[1], 4 * pi, 1e-8);
}

}  // namespace
}  // namespace umbilic::opinion
