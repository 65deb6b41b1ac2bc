// SPDX-License-Identifier: MIT
/// \file
/// The result of a run is the best of its levels, not the last.
#include <gtest/gtest.h>

#include <cmath>

#include "cage/generate.h"
#include "driver/run.h"
#include "mesh/coordinates.h"
#include "stress/cages.h"

namespace umbilic::test {
namespace {

/// Noise as long as the edges: finer levels see more of its curvature.
umbilic::Run noisy_run(const char* name, int iterations) {
  RunOptions options;
  options.weights = {1, 0, 0, 0, 0, 0};
  options.max_iterations = iterations;
  umbilic::Run run = *umbilic::Run::create(stress_cage(name), options);
  while (!run.step(100)) {
  }
  return run;
}

TEST(BestLevelSlow, is_the_result_where_a_later_one_ends_higher_or_hides_curvature) {
  int higher = 0, hiding = 0;
  for (const char* name :
       {"noise 0.3 on a torus", "noise 1 on a torus", "noise 0.3 on a frame", "noise 1 on a frame"}) {
    for (int iterations = 0; iterations < 4; ++iterations) {
      const umbilic::Run run = noisy_run(name, iterations);
      const LevelReport &result = run.result(), &last = run.levels().back();
      if (result.level == last.level) continue;
      if (result.credible == last.credible) {
        EXPECT_LT(result.energy_reported, last.energy_reported);
        ++higher;
      } else {
        EXPECT_TRUE(result.credible);
        ++hiding;
      }
    }
  }
  EXPECT_GE(higher, 2) << "the energies of these cages rise";
  EXPECT_GE(hiding, 1);
}

TEST(BestLevel, is_what_everything_is_reported_of) {
  const umbilic::Run run = noisy_run("noise 1 on a torus", 3);
  ASSERT_LT(run.result().level, 2);
  const LevelReport& result = run.result();
  EXPECT_EQ(run.energies().functionals[kBending], result.energy_reported);
  EXPECT_EQ(run.progress().level, result.level);
  EXPECT_EQ(run.patches(), result.patches);
  EXPECT_EQ(static_cast<int>(run.control_mesh().faces.size()), result.patches);
  EXPECT_EQ(static_cast<int>(run.limit_mesh(1)->quads.size()), result.patches);
  EXPECT_EQ(run.orbit_points(), run.control_mesh().vertices) << "there is no symmetry";
  int evaluations = 0;
  for (const LevelReport& level : run.levels()) evaluations += level.evaluations;
  EXPECT_EQ(run.progress().total_evaluations, evaluations);
  const double again = evaluate(run.control_mesh(), CapKind::kSmooth, 0)->energies.functionals[kBending];
  EXPECT_NEAR(again, result.energy_reported, 1e-12 * again);
  EXPECT_EQ(run.certify()->progress(), 0);
}

TEST(BestLevel, is_the_last_in_ordinary_runs) {
  RunOptions options;
  options.weights = {0, 0, 0, 1, 0, 0};
  umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), options);
  while (!run.step(100)) {
  }
  EXPECT_EQ(run.result().level, 2);
}

}  // namespace
}  // namespace umbilic::test
