// SPDX-License-Identifier: MIT
/// \file
/// All energies by both ways of computing: closed surfaces with every kind of cap, open ones, runs.
#include "driver/second_opinion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "cage/generate.h"
#include "driver/problem_run.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "problem/text.h"

namespace umbilic {
namespace {

/// All differences are within `second` and `third`, relative to the values. The invariants are odd, and may nearly
/// cancel: of them the second opinion's own error is allowed, too.
void expect_agreement(const OpinionReport& opinion, double second, double third, bool umbilics = true) {
  const OpinionValues &values = opinion.values, &differences = opinion.differences;
  for (int i = 0; i < kFunctionalCount; ++i) {
    const double value = values.functionals[i], difference = differences.functionals[i];
    if (std::isnan(value)) {
      EXPECT_TRUE(std::isnan(difference)) << kFunctionalNames[i];
      EXPECT_TRUE(is_third_order(i)) << kFunctionalNames[i];
      continue;
    }
    if (!umbilics && (i == kMvs || i == kMvsCross)) continue;
    EXPECT_NEAR(difference, 0, (is_third_order(i) ? third : second) * std::abs(value)) << kFunctionalNames[i];
  }
  EXPECT_NEAR(differences.area, 0, second * values.area);
  EXPECT_NEAR(differences.gaussian, 0, second * values.functionals[kBending]);
  for (int i = 0; i < kInvariantCount; ++i) {
    if (std::isnan(values.invariants[i])) continue;
    const double own = opinion.errors.invariants[i];
    EXPECT_NEAR(differences.invariants[i], 0, third * std::abs(values.invariants[i]) + own) << kInvariantNames[i];
  }
}

OpinionReport opinion_of(const std::string& cage, CapKind cap, int level) {
  const EvaluationReport report = *evaluate(*generate_cage(cage), cap, level, true);
  return report.second_opinion.value();
}

/// The tolerances are the errors of the reporting rule: the second opinion's own are far smaller, except for mvs and
/// mvs_cross, whose integrands jump at umbilic points, of which a cube has many.
TEST(SecondOpinionSlow, agrees_with_the_main_evaluation_of_smooth_caps) {
  expect_agreement(opinion_of("cube", CapKind::kSmooth, 1), 1e-7, 1e-3);
  expect_agreement(opinion_of("two-3", CapKind::kSmooth, 1), 1e-5, 3e-3);
}

TEST(SecondOpinion, agrees_without_caps_and_diverges_where_that_does) {
  expect_agreement(opinion_of("cube", CapKind::kNone, 1), 1e-8, 0);
}

TEST(SecondOpinionSlow, agrees_with_flat_caps_where_integrands_do_not_jump_at_umbilics) {
  expect_agreement(opinion_of("cube", CapKind::kFlat, 1), 1e-6, 1e-4, false);
}

TEST(SecondOpinionSlow, agrees_on_the_frame_of_genus_two_without_caps) {
  expect_agreement(opinion_of("two-3", CapKind::kNone, 1), 1e-5, 0);
}

TEST(SecondOpinionSlow, agrees_on_regular_surfaces_to_rounding) {
  expect_agreement(opinion_of("torus", CapKind::kSmooth, 1), 1e-11, 1e-8);
}

TEST(SecondOpinion, agrees_on_open_surfaces) {
  expect_agreement(opinion_of("catenoid", CapKind::kSmooth, 0), 1e-9, 1e-6);
  expect_agreement(opinion_of("spherical-cap", CapKind::kSmooth, 0), 1e-6, 1e-2);
}

/// What one face of each orbit finds, counted as often as the orbit has faces, is what all find.
TEST(SecondOpinion, of_one_face_of_each_orbit_is_that_of_all) {
  const RefinedCage cage = *refine_to_evaluable(*generate_cage("cube"), 1, true);
  ASSERT_EQ(cage.symmetry.order, 48);
  const EnergyReport none;
  const OpinionReport all = second_opinion(cage, CapKind::kSmooth, none);
  const OpinionReport one = second_opinion(cage, CapKind::kSmooth, none, OpinionFaces::kOnePerOrbit);
  for (const int i : {kBending, kWillmore, kMehlumTarrou, kSecondFormVariation}) {
    EXPECT_NEAR(one.values.functionals[i], all.values.functionals[i], 1e-9 * all.values.functionals[i])
        << kFunctionalNames[i];
  }
  EXPECT_NEAR(one.values.area, all.values.area, 1e-12 * all.values.area);
  EXPECT_NEAR(one.values.gaussian, 4 * std::numbers::pi, 1e-9);
  EXPECT_LT(10 * one.samples, all.samples);
}

/// The whole path from a problem to its report and back, for few faces, of which each takes long.
TEST(SecondOpinion, is_in_the_report_of_a_run_that_asks_for_it) {
  Problem problem =
      *parse_problem(R"({"umbilic": "problem", "version": 1, "cage": {"generator": "cube"}, "terms": {"bending": 1},)"
                     R"( "options": {"levels": [0, 0], "max_iterations": 1, "second_opinion": true}})");
  ProblemRun run = *begin_run(problem);
  while (!run.run.step(1000)) {
  }
  const Report report = run.report();
  ASSERT_TRUE(report.second_opinion.has_value());
  expect_agreement(*report.second_opinion, 1e-4, 1e-2);
  EXPECT_NEAR(report.second_opinion->values.functionals[kBending], report.energies.functionals[kBending], 1e-2);
  EXPECT_NE(report_text(report).find("\"second_opinion\""), std::string::npos);
  problem.options.second_opinion = false;
  ProblemRun other = *begin_run(problem);
  while (!other.run.step(1000)) {
  }
  EXPECT_FALSE(other.report().second_opinion.has_value());
}

/// The points of a closed cage are refined by another implementation of the step, too.
TEST(SecondOpinion, refines_closed_cages_otherwise_to_the_same_points) {
  const RefinedCage cage = *prepare(*generate_cage("two-3", {.family = FrameFamily::kHub}), 3, false);
  const RefinedCage main = refine(cage, 3), other = refine_otherwise(cage, 3);
  EXPECT_LT((main.control - other.control).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace umbilic
