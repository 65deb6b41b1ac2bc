// SPDX-License-Identifier: MIT
/// \file
/// Limits whose error knows that of the caps because the last level was minimized with narrower ones, too.
#include <gtest/gtest.h>

#include <cmath>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

/// Of MVS_cross on this cage, with caps of sixteen rings (tests/bench/README.md).
constexpr double kLimit = 3912.44;

RunOptions with_rings(const char* weights, int cap_rings, int last_level = 3) {
  RunOptions options;
  options.weights = *parse_weights(weights);
  options.cap_rings = cap_rings;
  options.last_level = last_level;
  return options;
}

umbilic::Run begun_with(const RunOptions& options) { return *umbilic::Run::create(*generate_cage("two-3"), options); }

umbilic::Run ended_with(const RunOptions& options) {
  umbilic::Run run = begun_with(options);
  while (!run.step(100)) {
  }
  return run;
}

/// A run whose next step is one of the comparison.
umbilic::Run comparing() {
  umbilic::Run run = begun_with(with_rings("mvs_cross=1", 2));
  while (run.progress().phase != Phase::kCompareCaps && !run.step(1)) {
  }
  return run;
}

TEST(NarrowerCaps, are_compared_where_the_last_level_did_not_widen_them) {
  const umbilic::Run two = ended_with(with_rings("mvs_cross=1", 2)), one = ended_with(with_rings("mvs_cross=1", 1)),
                     four = ended_with(with_rings("mvs_cross=1", 4, 2));
  const LevelReport &compared = two.levels()[2], &narrow = one.levels()[2];
  EXPECT_EQ(compared.cap_rings, 2);
  const double difference = narrow.energy_reported - compared.energy_reported;
  EXPECT_NEAR(compared.narrower_caps_energy - compared.energy_reported, difference, 0.5 * difference)
      << "another minimum of the parametrization";
  EXPECT_GT(compared.narrower_caps_evaluations, 0);
  const LimitReport limit = two.limit();
  ASSERT_EQ(limit.status, LimitStatus::kConverging);
  EXPECT_TRUE(limit.caps_included);
  EXPECT_LT(std::abs(limit.energy - kLimit), limit.error);
  EXPECT_EQ(two.result().level, 3);
  for (const LevelReport& level : four.levels()) {
    EXPECT_EQ(level.narrower_caps_evaluations, 0) << "where they widened";
  }
  EXPECT_EQ(narrow.narrower_caps_evaluations, 0) << "where there are no narrower ones";
  EXPECT_FALSE(one.limit().caps_included);
}

TEST(NarrowerCaps, are_not_compared_for_functionals_that_do_not_depend_on_them) {
  const umbilic::Run run = ended_with(with_rings("bending=1", 2));
  ASSERT_EQ(run.limit().status, LimitStatus::kConverging);
  EXPECT_TRUE(run.limit().caps_included);
  EXPECT_EQ(run.levels()[2].narrower_caps_evaluations, 0);
}

TEST(NarrowerCaps, leave_the_surface_as_it_is) {
  umbilic::Run run = comparing();
  ASSERT_EQ(run.progress().phase, Phase::kCompareCaps);
  const Points surface = run.control_mesh().vertices;
  const int level = run.progress().level, evaluations = run.progress().total_evaluations;
  double share = run.progress().share_done;
  EXPECT_LT(share, 1);
  while (!run.step(1)) {
    EXPECT_EQ(run.control_mesh().vertices, surface);
    EXPECT_GE(run.progress().share_done, share);
    EXPECT_GT(run.progress().seconds_left, 0);
    share = run.progress().share_done;
  }
  EXPECT_EQ(run.control_mesh().vertices, surface);
  EXPECT_EQ(run.progress().level, level);
  EXPECT_EQ(run.progress().total_evaluations, evaluations + run.levels()[2].narrower_caps_evaluations);
  EXPECT_EQ(run.progress().share_done, 1);
}

TEST(NarrowerCaps, may_be_cancelled_and_retargeted) {
  umbilic::Run cancelled = comparing();
  cancelled.step(3);
  const Points surface = cancelled.control_mesh().vertices;
  cancelled.cancel();
  EXPECT_EQ(cancelled.progress().phase, Phase::kDone);
  EXPECT_EQ(cancelled.control_mesh().vertices, surface);
  EXPECT_EQ(cancelled.levels().back().stop, StopReason::kConverged);
  EXPECT_FALSE(cancelled.limit().caps_included);

  umbilic::Run other = comparing();
  other.step(3);
  Targets targets;
  targets.terms = *parse_weights("bending=1");
  ASSERT_FALSE(other.retarget(targets));
  EXPECT_EQ(other.progress().phase, Phase::kPrepare);
  while (!other.step(100)) {
  }
  EXPECT_EQ(other.levels().back().stop, StopReason::kConverged);
}

}  // namespace
}  // namespace umbilic
