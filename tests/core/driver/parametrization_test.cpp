// SPDX-License-Identifier: MIT
/// \file
/// The stages of the term that keeps parametrizations even, and what a run without symmetry reports of them.
#include "driver/parametrization.h"

#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "mesh/rough_cages.h"
#include "solve/stop_reason.h"

namespace umbilic::test {
namespace {

constexpr Weights kMvsCrossOnly{0, 0, 0, 1, 0, 0};

Cage moved_cage() {
  Cage cage = *generate_cage("cube");
  cage.vertices += 0.1 * Random(1).points(cage.vertices.rows());
  return cage;
}

TEST(ParametrizationStages, weigh_the_term_by_its_share_of_the_energy_until_it_is_0) {
  const Surface surface(*refine_to_evaluable(moved_cage(), 1, false), CapKind::kSmooth, kMvsCrossOnly);
  ParametrizationStages stages;
  EXPECT_TRUE(stages.last());
  EXPECT_EQ(stages.weight(), 0);
  stages.begin(surface.energy(), surface.start());
  for (const double share : kParametrizationShares) {
    const EnergyValue value = surface.energy().evaluate(surface.start(), nullptr, stages.weight());
    EXPECT_NEAR(value.parametrization, share * value.energy, 1e-12 * value.energy);
    EXPECT_EQ(stages.last(), share == 0);
    if (!stages.last()) stages.advance(surface.energy(), surface.start());
  }
  EXPECT_EQ(stages.begun(), static_cast<int>(kParametrizationShares.size()));
}

TEST(ParametrizationStagesSlow, of_a_run_without_symmetry_are_reported_and_its_energies_are_the_functionals_alone) {
  RunOptions options;
  options.weights = kMvsCrossOnly;
  options.last_level = 1;
  umbilic::Run run = *umbilic::Run::create(moved_cage(), options);
  while (!run.step(100)) {
  }
  ASSERT_EQ(run.group().order, 1);
  for (const LevelReport& level : run.levels()) {
    EXPECT_EQ(level.metric, MetricChoice::kNewton);
    EXPECT_EQ(level.parametrization_stages, static_cast<int>(kParametrizationShares.size()));
    EXPECT_TRUE(level.stop == StopReason::kConverged || level.stop == StopReason::kRoundOff) << name_of(level.stop);
    EXPECT_NEAR(level.energy, level.energy_reported, 0.1 * level.energy_reported);
  }

  // A run that goes on from there does not make even again what has been minimized.
  const SurfaceState reached = run.state();
  options.first_level = 1;
  umbilic::Run further = *umbilic::Run::create(moved_cage(), options, {}, reached);
  while (!further.step(100)) {
  }
  EXPECT_EQ(further.levels().front().parametrization_stages, 0);
  EXPECT_LE(further.result().energy_reported, run.result().energy_reported * (1 + 1e-6));
}

TEST(ParametrizationStages, are_left_out_where_symmetry_holds_the_parametrization) {
  RunOptions options;
  options.weights = kMvsCrossOnly;
  options.last_level = 0;
  umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), options);
  while (!run.step(100)) {
  }
  EXPECT_EQ(run.levels().front().parametrization_stages, 0);
  EXPECT_EQ(run.levels().front().metric, MetricChoice::kHessian);
}

TEST(ParametrizationStages, that_are_interrupted_leave_the_energy_of_the_best_surface) {
  RunOptions options;
  options.weights = kMvsCrossOnly;
  options.first_level = options.last_level = 1;
  umbilic::Run run = *umbilic::Run::create(moved_cage(), options);
  while (run.progress().evaluations < 3) run.step(1);
  const double energy = run.progress().energy;
  run.cancel();
  const Surface surface(*refine_to_evaluable(run.control_mesh(), 0, false), CapKind::kSmooth, kMvsCrossOnly);
  EXPECT_NEAR(surface.energy().evaluate(surface.start(), nullptr).energy, energy, 1e-6 * energy);
}

}  // namespace
}  // namespace umbilic::test
