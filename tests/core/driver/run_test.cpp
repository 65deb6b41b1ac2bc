// SPDX-License-Identifier: MIT
/// \file
/// Runs: their contract step by step, and what goes wrong in them.
#include "driver/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "cage/generate.h"
#include "cage/read.h"

namespace umbilic {
namespace {

constexpr double kSphereBending = 8 * std::numbers::pi;

RunOptions minimizing(std::string_view weights, int first, int last) {
  RunOptions options;
  options.weights = *parse_weights(weights);
  options.first_level = first;
  options.last_level = last;
  return options;
}

umbilic::Run finished(const Cage& cage, const RunOptions& options) {
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(1)) {
  }
  return run;
}

TEST(Run, takes_one_evaluation_or_less_per_unit_and_ends_level_by_level) {
  umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), minimizing("bending=1", 1, 2));
  int evaluations = 0;
  std::size_t levels = 0;
  double energy = std::nan("");
  int level = run.progress().level;
  while (!run.step(1)) {
    const Progress& p = run.progress();
    EXPECT_LE(p.total_evaluations, evaluations + 1);
    evaluations = p.total_evaluations;
    if (p.level == level && std::isfinite(energy)) {
      EXPECT_LE(p.energy, energy);
    }
    EXPECT_GE(p.level, level);
    EXPECT_GE(run.levels().size(), levels);
    level = p.level;
    levels = run.levels().size();
    energy = p.energy;
  }
  ASSERT_EQ(run.levels().size(), 2u);
  EXPECT_EQ(run.levels()[0].level, 1);
  EXPECT_EQ(run.levels()[1].level, 2);
  EXPECT_EQ(run.levels()[1].patches, 4 * run.levels()[0].patches);
  EXPECT_EQ(run.progress().total_evaluations, run.levels()[0].evaluations + run.levels()[1].evaluations);
  EXPECT_EQ(run.progress().phase, Phase::kDone);
  EXPECT_TRUE(run.step(5));
}

TEST(Run, goes_on_with_a_level_that_has_converged_above_the_one_before) {
  RunOptions options = minimizing("bending=1", 0, 4);
  options.tolerance = 1;  // so lax that levels would end with the caps that they begin with
  const umbilic::Run run = finished(*generate_cage("cube"), options);
  const std::vector<LevelReport>& levels = run.levels();
  ASSERT_EQ(levels.size(), 5u);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_LE(levels[i].energy_reported, (1 + 1.5e-4) * levels[i - 1].energy_reported) << "level " << i;
  }
  EXPECT_EQ(run.limit().status, LimitStatus::kNotMinimized) << "what has seemed to converge once may do so again";
}

TEST(Run, gives_the_same_digits_whether_stepped_singly_or_in_bulk) {
  const Cage cage = *generate_cage("two-3");
  const umbilic::Run single = finished(cage, minimizing("bending=1", 0, 1));
  umbilic::Run bulk = *umbilic::Run::create(cage, minimizing("bending=1", 0, 1));
  while (!bulk.step(37)) {
  }
  EXPECT_EQ(single.control_mesh().vertices, bulk.control_mesh().vertices);
  EXPECT_EQ(single.levels()[1].energy, bulk.levels()[1].energy);
}

TEST(Run, reports_energies_that_the_control_mesh_reproduces) {
  for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat}) {
    RunOptions options = minimizing("mvs_cross=1", 1, 1);
    options.cap = cap;
    options.max_iterations = 5;
    const umbilic::Run run = finished(*generate_cage("two-3"), options);
    const EvaluationReport again = *evaluate(run.control_mesh(), cap, 0);
    for (int i = 0; i < kFunctionalCount; ++i) {
      EXPECT_NEAR(again.energies.functionals[i], run.energies().functionals[i], 1e-12 * run.energies().functionals[i]);
    }
    EXPECT_EQ(run.levels()[0].energy_reported, run.energies().functionals[kMvsCross]);
    EXPECT_NEAR(run.energies().quadrature_error, std::abs(run.levels()[0].energy_reported - run.levels()[0].energy),
                1e-9 * run.levels()[0].energy);
  }
}

TEST(Run, keeps_its_best_surface_when_cancelled_at_any_moment) {
  for (int units = 0; units < 150; units += 7) {
    umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), minimizing("bending=1", 0, 2));
    run.step(units);
    const Points before = run.control_mesh().vertices;
    const int level = run.progress().level;
    const bool ended_by_itself = run.progress().phase == Phase::kReport;
    const double energy = run.energies().functionals[kBending];
    run.cancel();
    ASSERT_FALSE(run.levels().empty());
    if (run.result().level == level) {
      EXPECT_EQ(run.control_mesh().vertices, before);
    } else {  // the level has not come below the one before yet
      EXPECT_LT(run.energies().functionals[kBending], energy);
    }
    if (!ended_by_itself) {
      EXPECT_EQ(run.levels().back().stop, StopReason::kCancelled);
    }
    EXPECT_EQ(run.levels().back().level, level);
    EXPECT_TRUE(std::isfinite(run.levels().back().energy));
    EXPECT_TRUE(run.step(1));
    EXPECT_EQ(run.progress().phase, Phase::kDone);
  }
}

TEST(Run, of_no_iterations_reports_the_surface_as_it_is) {
  RunOptions options = minimizing("bending=1", 1, 1);
  options.max_iterations = 0;
  const Cage cage = *generate_cage("cube");
  const umbilic::Run run = finished(cage, options);
  EXPECT_EQ(run.levels()[0].stop, StopReason::kMaxIterations);
  const double expected = evaluate(cage, CapKind::kSmooth, 1)->energies.functionals[kBending];
  EXPECT_NEAR(run.energies().functionals[kBending], expected, 1e-12 * expected);  // of one patch for each orbit
}

TEST(Run, moves_the_points_of_a_cage_that_only_a_finer_mesh_can_be_evaluated_for) {
  const Cage cage = *generate_cage("two-3", {.family = FrameFamily::kHub});
  umbilic::Run run = *umbilic::Run::create(cage, minimizing("bending=1", 0, 2));
  EXPECT_EQ(run.progress().level, 0);
  while (!run.step(100)) {
  }
  ASSERT_EQ(run.levels().size(), 3u);
  for (int level = 0; level < 3; ++level) {
    const LevelReport& report = run.levels()[level];
    EXPECT_EQ(report.level, level);
    EXPECT_EQ(report.evaluable, level == 2);
    EXPECT_EQ(report.patches, run.levels()[2].patches);
    if (level > 0) {
      EXPECT_LT(report.energy, run.levels()[level - 1].energy);
    }
  }
  umbilic::Run coarse = finished(cage, minimizing("bending=1", 0, 0));
  EXPECT_EQ(coarse.control_mesh().faces.size(), cage.faces.size());
  EXPECT_NEAR(evaluate(coarse.control_mesh(), CapKind::kSmooth, 0)->energies.functionals[kBending],
              coarse.levels()[0].energy_reported, 1e-10 * coarse.levels()[0].energy_reported);
}

TEST(Run, refuses_options_out_of_range_and_functionals_that_diverge) {
  const Cage cage = *generate_cage("cube");
  const auto message = [&](const RunOptions& options) { return umbilic::Run::create(cage, options).error().message; };
  EXPECT_EQ(message(RunOptions{}), "all weights are zero");
  RunOptions options = minimizing("bending=1", 2, 1);
  EXPECT_EQ(message(options), "levels[1]: 1 is below levels[0], 2");
  options = minimizing("bending=1", 0, 12);
  EXPECT_NE(message(options).find("at most 2000000"), std::string::npos);
  options = minimizing("mvs=1", 1, 1);
  options.cap = CapKind::kNone;
  EXPECT_NE(message(options).find("mvs diverges at extraordinary vertices"), std::string::npos);
  options.weights = *weights_of("bending");
  EXPECT_TRUE(umbilic::Run::create(cage, options).ok());
}

TEST(Run, evaluation_and_gradient_take_open_cages) {
  const Cage open = *read_cage("v 0 0 0\nv 1 0 0\nv 1 1 0.3\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_TRUE(umbilic::Run::create(open, minimizing("bending=1", 0, 1)));
  EXPECT_GT(evaluate(open, CapKind::kSmooth, 0)->energies.functionals[kBending], 0);
  EXPECT_TRUE(check_gradient(open, *parse_weights("bending=1"), CapKind::kSmooth)->ok);
}

TEST(Run, reports_third_order_energies_without_a_cap_as_not_a_number) {
  const EvaluationReport report = *evaluate(*generate_cage("cube"), CapKind::kNone, 1);
  EXPECT_TRUE(std::isnan(report.energies.functionals[kMvs]));
  EXPECT_TRUE(std::isfinite(report.energies.functionals[kBending]));
  EXPECT_TRUE(std::isfinite(evaluate(*generate_cage("torus"), CapKind::kNone, 0)->energies.functionals[kMvs]));
}

TEST(Run, bending_of_a_cube_becomes_that_of_the_sphere) {
  const umbilic::Run run = finished(*generate_cage("cube"), minimizing("bending=1", 0, 2));
  const double energy = run.levels().back().energy_reported;
  EXPECT_GT(energy, kSphereBending * (1 - 1e-7));
  EXPECT_LT(energy, kSphereBending * (1 + 1e-3));
}

TEST(Run, gradients_of_generated_cages_agree_with_differences) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    const GradientReport report = *check_gradient(*generate_cage("two-3"), *weights_of(functional), CapKind::kSmooth);
    EXPECT_TRUE(report.ok) << functional << " " << report.relative_mismatch;
  }
}

}  // namespace
}  // namespace umbilic
