// SPDX-License-Identifier: MIT
/// \file
/// Caps of sixteen rings around vertices of low valence: the middles of holes of three and five sides.
#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

Cage hole(int sides) {
  CageOptions options;
  options.sides = sides;
  options.rise = 0.25;
  options.major_segments = 4;
  return *generate_cage("n-sided", options);
}

TEST(WideCaps, of_sixteen_rings_are_those_of_eight_on_a_mesh_refined_once_more) {
  for (const int sides : {3, 5}) {
    const EvaluationReport eight = *evaluate(hole(sides), {CapKind::kSmooth, 8}, 3),
                           sixteen = *evaluate(hole(sides), {CapKind::kSmooth, 16}, 4);
    for (const int functional : {kBending, kMvsCross}) {
      const double expected = eight.energies.functionals[functional];
      EXPECT_NEAR(sixteen.energies.functionals[functional], expected, 1e-7 * expected) << sides << " sides";
    }
  }
}

TEST(WideCapsSlow, let_runs_around_low_valences_converge) {
  for (const int sides : {3, 5}) {
    RunOptions options;
    options.weights = *parse_weights("mvs_cross=1");
    options.cap_rings = 16;
    options.last_level = 4;
    Constraints constraints;
    constraints.boundary = BoundaryConditions{BoundaryCondition::kCurvature, {}};
    umbilic::Run run = *umbilic::Run::create(hole(sides), options, constraints);
    while (!run.step(100)) {
    }
    double before = 1e300;
    for (const LevelReport& level : run.levels()) {
      EXPECT_EQ(level.stop, StopReason::kConverged) << sides << " sides, level " << level.level;
      EXPECT_LT(level.energy_reported, before);
      before = level.energy_reported;
    }
  }
}

}  // namespace
}  // namespace umbilic
