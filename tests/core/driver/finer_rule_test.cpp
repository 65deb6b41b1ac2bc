// SPDX-License-Identifier: MIT
/// \file
/// Runs whose surface makes use of the quadrature's error, as bending of the dodecahedron's flag cage does at level 2:
/// patches stretch until the curvature between the samples is more than that at them.
#include <gtest/gtest.h>

#include <cmath>

#include "cage/generate.h"
#include "driver/rules.h"
#include "driver/run.h"

namespace umbilic {
namespace {

constexpr int kStretchedLevel = 2;

umbilic::Run stretching(int max_iterations = 1000) {
  RunOptions options;
  options.weights = *weights_of("bending");
  options.last_level = kStretchedLevel;
  options.max_iterations = max_iterations;
  return *umbilic::Run::create(*generate_cage("dodecahedron-frame"), options);
}

double relative_error(const LevelReport& level) {
  return std::abs(level.energy - level.energy_reported) / level.energy_reported;
}

/// Whether the next unit of work is the first by a finer rule: the level prepares once more.
bool begins_again(const umbilic::Run& run) {
  return run.progress().phase == Phase::kPrepare && run.progress().evaluations > 0;
}

TEST(FinerRule, is_needed_where_the_error_is_a_share_of_the_gain_and_more_than_a_limit_could_bear) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
      const auto exploits = [&](double start, double energy, double reported) {
        return exploits_quadrature(*weights_of(functional), scale * start, scale * energy, scale * reported);
      };
      EXPECT_TRUE(exploits(362.8, 351.2, 352.6)) << "an eighth of the gain";
      EXPECT_TRUE(exploits(362.8, 354.0, 352.6)) << "of either sign";
      EXPECT_TRUE(exploits(352.5, 351.2, 352.6)) << "with nothing gained at all";
      EXPECT_FALSE(exploits(362.8, 352.5, 352.6)) << "a hundredth";
      EXPECT_FALSE(exploits(352.6, 352.59, 352.6)) << "all of a gain, but of a size that matters to nobody";
      EXPECT_FALSE(exploits(362.8, 351.2, std::nan("")));
    }
  }
}

TEST(FinerRule, of_so_many_more_steps_has_more_samples_of_every_kind) {
  for (const CapKind cap : {CapKind::kNone, CapKind::kFlat, CapKind::kSmooth}) {
    for (const char* functional : {"bending", "mvs_cross"}) {
      const Weights weights = *weights_of(functional);
      EXPECT_EQ(minimizing_rule(cap, weights, 0), minimizing_rule(cap, weights));
      for (int steps = 1; steps <= kFinestRules; ++steps) {
        const QuadratureRule rule = minimizing_rule(cap, weights, steps);
        const QuadratureRule before = minimizing_rule(cap, weights, steps - 1);
        EXPECT_GT(rule.regular_points, before.regular_points);
        EXPECT_GT(rule.cap_points, before.cap_points);
        EXPECT_GE(rule.grading, before.grading);
        EXPECT_GT(hessian_rule(cap, weights, steps), hessian_rule(cap, weights, steps - 1));
      }
    }
  }
}

TEST(FinerRule, makes_a_level_converge_whose_surface_makes_use_of_the_usual_rules_error) {
  umbilic::Run run = stretching();
  double energy = std::nan("");
  int rises = 0, evaluations = 0;
  while (!run.step(1)) {
    const Progress& p = run.progress();
    if (p.level != kStretchedLevel) continue;
    EXPECT_GE(p.total_evaluations, evaluations);
    evaluations = p.total_evaluations;
    if (p.energy > energy) ++rises;
    if (std::isfinite(p.energy)) energy = p.energy;
  }
  ASSERT_EQ(run.levels().size(), 3u);
  for (const LevelReport& level : run.levels()) {
    EXPECT_EQ(name_of(level.stop), "converged");
    EXPECT_LE(relative_error(level), 2e-4) << "what a level without gain could live with, twice";
  }
  EXPECT_EQ(run.levels()[0].quadrature, 0);
  EXPECT_EQ(run.levels()[1].quadrature, 0);
  EXPECT_GE(run.levels()[2].quadrature, 1);
  EXPECT_EQ(rises, run.levels()[2].quadrature) << "only where the rule changes";
  EXPECT_EQ(run.progress().evaluations, run.levels()[2].evaluations);
  EXPECT_EQ(run.progress().iterations, run.levels()[2].iterations);
  EXPECT_EQ(run.progress().total_evaluations,
            run.levels()[0].evaluations + run.levels()[1].evaluations + run.levels()[2].evaluations);
  EXPECT_LT(run.levels()[2].energy_reported, 351.9) << "351.735 is what finer levels tend to";
  EXPECT_GT(run.levels()[2].energy, 351.73) << "351.2 is what the usual rule sees";
}

TEST(FinerRule, begins_with_the_best_surface_so_far_which_a_cancelled_run_keeps) {
  umbilic::Run run = stretching();
  while (!begins_again(run)) ASSERT_FALSE(run.step(1));
  const Points best = run.control_mesh().vertices;
  const int evaluations = run.progress().evaluations;
  while (run.progress().evaluations == evaluations) {
    ASSERT_FALSE(run.step(1));
    const double moved = (run.control_mesh().vertices - best).norm();
    EXPECT_LE(moved, 1e-12 * best.norm()) << "its coordinates are taken anew";
  }
  const Points begun = run.control_mesh().vertices;
  const EnergyReport energies = run.energies();
  run.cancel();
  EXPECT_EQ(run.control_mesh().vertices, begun);
  const LevelReport& level = run.levels().back();
  EXPECT_EQ(level.stop, StopReason::kCancelled);
  EXPECT_EQ(level.quadrature, 1);
  EXPECT_EQ(level.evaluations, evaluations + 1);
  EXPECT_GT(level.iterations, 0);
  EXPECT_GT(level.metrics, 1);
  EXPECT_EQ(level.energy_reported, energies.functionals[kBending]);
  EXPECT_NEAR(level.energy, level.energy_reported, energies.quadrature_error + 1e-9);
}

TEST(FinerRule, shares_the_iterations_of_its_level) {
  umbilic::Run run = stretching(100);
  while (!run.step(100)) {
  }
  EXPECT_EQ(run.levels()[2].stop, StopReason::kMaxIterations);
  EXPECT_EQ(run.levels()[2].iterations, 100);
  EXPECT_EQ(run.levels()[2].quadrature, 0) << "none are left";
  umbilic::Run longer = stretching(115);
  while (!longer.step(100)) {
  }
  EXPECT_LE(longer.levels()[2].iterations, 115);
}

TEST(FinerRule, is_left_alone_by_runs_whose_quadrature_is_good) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    RunOptions options;
    options.weights = *weights_of(functional);
    umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), options);
    while (!run.step(100)) {
    }
    for (const LevelReport& level : run.levels()) EXPECT_EQ(level.quadrature, 0) << functional;
  }
}

}  // namespace
}  // namespace umbilic
