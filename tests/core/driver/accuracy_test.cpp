// SPDX-License-Identifier: MIT
/// \file
/// Runs that are asked for an accuracy instead of levels.
#include <gtest/gtest.h>

#include <cmath>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

umbilic::Run run_within(const char* functional, double accuracy) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.accuracy = accuracy;
  umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), options);
  while (!run.step(1000)) {
  }
  return run;
}

TEST(Accuracy, is_reached_by_the_first_level_that_tells_and_holds) {
  constexpr double kLawson = 112.7668;  // the least known bending energy of genus 2
  std::size_t levels_before = 0;
  int evaluations_before = 0;
  for (const double accuracy : {0.05, 1e-3, 1e-5}) {
    const umbilic::Run run = run_within("bending", accuracy);
    const LimitReport limit = run.limit();
    EXPECT_LE(limit.relative_error(), accuracy);
    EXPECT_NEAR(limit.energy, kLawson, limit.error + 1e-4);
    EXPECT_GE(run.levels().size(), 3u) << "fewer tell no limit";
    EXPECT_GE(run.levels().size(), levels_before);
    EXPECT_GT(run.progress().total_evaluations, evaluations_before) << "no level is minimized further than matters";
    levels_before = run.levels().size();
    evaluations_before = run.progress().total_evaluations;
  }
  EXPECT_GT(levels_before, 3u) << "as many as it takes";
}

TEST(AccuracySlow, that_cannot_be_reached_ends_after_six_levels) {
  const umbilic::Run run = run_within("bending", 1e-12);
  EXPECT_EQ(run.levels().size(), 6u);
  EXPECT_GT(run.limit().relative_error(), 1e-12);
}

TEST(Accuracy, of_no_limit_ends_after_five_levels) {
  RunOptions options;
  options.weights = *weights_of("bending");
  options.accuracy = 0.01;
  options.max_iterations = 2;
  umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), options);
  while (!run.step(1000)) {
  }
  EXPECT_EQ(run.limit().status, LimitStatus::kNotMinimized);
  EXPECT_EQ(run.levels().size(), 5u);
}

TEST(Accuracy, is_between_nothing_and_everything) {
  for (const double accuracy : {0., -0.1, 1., std::nan("")}) {
    RunOptions options;
    options.weights = *weights_of("bending");
    options.accuracy = accuracy;
    const Result<umbilic::Run> run = umbilic::Run::create(*generate_cage("cube"), options);
    ASSERT_FALSE(run) << accuracy;
    EXPECT_EQ(run.error().message.find("accuracy: "), 0u) << run.error().message;
  }
}

TEST(Accuracy, cannot_be_told_where_each_level_is_pulled_with_its_own_weight) {
  RunOptions options;
  options.weights = *weights_of("bending");
  options.accuracy = 0.01;
  Constraints constraints;
  constraints.closeness = Closeness{{}, 0.1};
  const Result<umbilic::Run> run = umbilic::Run::create(*generate_cage("cube"), options, constraints);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().message.find("accuracy: "), 0u) << run.error().message;
}

}  // namespace
}  // namespace umbilic
