// SPDX-License-Identifier: MIT
/// \file
/// Surfaces that are pulled to the cage's own, and the search for how strongly.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "cage/generate.h"
#include "driver/closeness_search.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "optimize/closeness_term.h"

namespace umbilic {
namespace {

umbilic::Run pulled(const Cage& cage, const char* functional, int last_level, const Closeness& closeness,
                    double tolerance = 1e-6) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = last_level;
  options.tolerance = tolerance;
  Constraints constraints;
  constraints.closeness = closeness;
  umbilic::Run run = *umbilic::Run::create(cage, options, constraints);
  while (!run.step(1000)) {
  }
  return run;
}

/// A translation by t moves every point by t: the integral is area |t|^2.
TEST(ClosenessTerm, of_a_translation_is_the_area_times_its_square) {
  for (const char* name : {"cube", "two-3", "torus"}) {
    const RefinedCage cage = *refine_to_evaluable(*generate_cage(name), 1, false);
    const Surface surface(cage, CapKind::kSmooth, *weights_of("bending"));
    const double weight = 3;
    const ClosenessTerm term(surface.layout(), cage.control, weight);
    Points moved = cage.control;
    moved.rowwise() += Eigen::RowVector3d(0.1, -0.2, 0.3);
    const double area = surface.energy().evaluate(cage.control, nullptr).area;
    EXPECT_NEAR(term.evaluate(moved, nullptr), weight * area * 0.14, 2e-4 * area) << name;
    EXPECT_EQ(term.evaluate(cage.control, nullptr), 0) << name;
  }
}

TEST(ClosenessTerm, has_its_gradient_and_its_second_derivatives) {
  const RefinedCage cage = *refine_to_evaluable(*generate_cage("two-3"), 1, false);
  const Surface surface(cage, CapKind::kSmooth, *weights_of("bending"));
  const ClosenessTerm term(surface.layout(), cage.control, 2);
  Points direction = Points::Random(cage.control.rows(), 3), gradient = Points::Zero(cage.control.rows(), 3);
  const Points at = cage.control + 0.1 * Points::Random(cage.control.rows(), 3);
  term.evaluate(at, &gradient);
  const double slope = gradient.cwiseProduct(direction).sum();
  // A quadratic function: central differences are exact but for rounding.
  const double difference = (term.evaluate(at + direction, nullptr) - term.evaluate(at - direction, nullptr)) / 2;
  EXPECT_NEAR(difference, slope, 1e-11 * std::abs(slope));
}

TEST(ClosenessTerm, of_symmetric_displacements_is_the_same_with_one_patch_of_each_orbit) {
  const Cage cage = *generate_cage("two-3");
  const RefinedCage symmetric = *refine_to_evaluable(cage, 1, true), free = *refine_to_evaluable(cage, 1, false);
  const Surface few(symmetric, CapKind::kSmooth, *weights_of("bending")),
      all(free, CapKind::kSmooth, *weights_of("bending"));
  const Points grown = 1.1 * symmetric.control;
  const double one = ClosenessTerm(few.layout(), symmetric.control, 1).evaluate(grown, nullptr);
  EXPECT_NEAR(one, ClosenessTerm(all.layout(), symmetric.control, 1).evaluate(grown, nullptr), 1e-12 * one);
}

TEST(Closeness, of_a_larger_weight_deviates_less_and_of_none_is_the_free_minimum) {
  const Cage cage = *generate_cage("two-3");
  double before = 1e9;
  for (const double weight : {0., 1e2, 1e4, 1e6}) {
    const umbilic::Run run = pulled(cage, "bending", 1, {weight, {}});
    const double deviation = run.constraints()->deviation;
    EXPECT_LT(deviation, before) << weight;
    EXPECT_EQ(*run.constraints()->closeness, weight);
    before = deviation;
  }
  EXPECT_LT(before, 1e-2);
}

/// A weight is an energy per length^4: a cage of twice the size needs a sixteenth of it.
TEST(Closeness, scales_with_the_cage) {
  Cage cage = *generate_cage("two-3");
  const double small = pulled(cage, "mvs_cross", 1, {1600., {}}).result().energy;
  cage.vertices *= 2;
  EXPECT_EQ(pulled(cage, "mvs_cross", 1, {100., {}}).result().energy, small);
}

TEST(Closeness, within_a_distance_is_held_and_used_up) {
  for (const char* name : {"two-3", "cube", "tetrahedron-frame"}) {
    Cage cage = *generate_cage(name);
    cage.vertices *= 10;
    for (const double within : {0.05, 0.12}) {  // the cube's sphere of the best size deviates by 0.17
      const umbilic::Run run = pulled(cage, "bending", 1, {{}, within}, 1e-4);
      const double deviation = run.constraints()->deviation;
      EXPECT_LE(deviation, within) << name;
      EXPECT_GE(deviation, 0.9 * within) << name;
      EXPECT_EQ(run.progress().level, 1);
    }
  }
}

TEST(ClosenessSearch, finds_weights_of_monotone_functions_and_sees_where_none_is_needed) {
  for (const double exponent : {0.3, 1., 2.}) {
    for (const double first : {1e-4, 1., 1e5}) {
      ClosenessSearch search(0.01, first);
      int trials = 1;
      const auto deviation = [&] { return std::pow(1 + 100 * search.weight(), -exponent); };
      while (!search.accepts(deviation())) ++trials;
      EXPECT_LE(deviation(), 0.01);
      EXPECT_GE(deviation(), 0.009);
      EXPECT_TRUE(search.binds());
      EXPECT_LT(trials, 30);
    }
  }
  ClosenessSearch near(1, 1);
  while (!near.accepts(0.5 / (1 + near.weight()))) {
  }
  EXPECT_FALSE(near.binds());
}

TEST(Closeness, needs_either_a_weight_or_a_distance) {
  RunOptions options;
  options.weights = *weights_of("bending");
  const auto message = [&](const Closeness& closeness) {
    Constraints constraints;
    constraints.closeness = closeness;
    return umbilic::Run::create(*generate_cage("cube"), options, constraints).error().message;
  };
  EXPECT_EQ(message({}), "constraints.closeness.weight: expected either this or within");
  EXPECT_EQ(message({1., 1.}), "constraints.closeness.weight: expected either this or within");
  EXPECT_EQ(message({-1., {}}), "constraints.closeness.weight: -1 is not a finite number >= 0");
  EXPECT_EQ(message({{}, 0.}), "constraints.closeness.within: 0 is not a finite number > 0");
}

}  // namespace
}  // namespace umbilic
