// SPDX-License-Identifier: MIT
/// \file
/// Runs and evaluations that end with what cannot be a surface's energies, and what small energies prove.
#include "driver/contradiction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "driver/run.h"
#include "stress/cages.h"

namespace umbilic::test {
namespace {

using std::numbers::pi;

umbilic::Run judged(const Cage& cage, std::string_view weights, int iterations = 1000, int last_level = 2) {
  RunOptions options;
  options.weights = *parse_weights(weights);
  options.max_iterations = iterations;
  options.last_level = last_level;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(100)) {
  }
  return run;
}

TEST(Contradiction, allows_for_the_error_that_is_known_but_for_a_percent_at_most) {
  EXPECT_FALSE(below(10, 10, 0));
  EXPECT_FALSE(below(10, 10 - 1e-9, 0)) << "rounding";
  EXPECT_TRUE(below(10, 10 - 1e-7, 0));
  EXPECT_FALSE(below(10, 10 - 1e-7, 1.1e-7));
  EXPECT_TRUE(below(10, 9.8, 1e9));
  EXPECT_TRUE(below(10, 9.8, std::nan("")));
  EXPECT_FALSE(below(0, 0, 0));
  EXPECT_FALSE(below(0, 1e-300, 0));
}

TEST(Contradiction, ends_all_levels_of_a_flat_box_whatever_the_functional) {
  for (const char* weights : {"bending=1", "willmore=1", "mvs=1", "mvs_cross=1", "bending=1,mvs=1"}) {
    const umbilic::Run run = judged(stress_cage("flat box"), weights);
    for (const LevelReport& level : run.levels()) {
      EXPECT_EQ(name_of(level.stop), "below_bound") << weights;
      EXPECT_FALSE(level.credible);
    }
    EXPECT_TRUE(run.energies().below_bound);
    EXPECT_FALSE(run.energies().embedded);
  }
}

TEST(Contradiction, of_gauss_and_bonnet_ends_a_sphere_that_covers_another_twice) {
  // Branched at the poles: the integral of K is 8 pi instead of 4 pi, and bending above its bound.
  const umbilic::Run run = judged(wound_sphere(6, 3, 2), "bending=1", 200, 1);
  EXPECT_EQ(name_of(run.levels().back().stop), "not_resolved");
  EXPECT_FALSE(run.energies().resolved);
  EXPECT_FALSE(run.energies().below_bound);
}

TEST(Contradiction, is_not_seen_in_minimizers_that_attain_their_bound) {
  for (const char* name : {"cube", "torus"}) {
    for (const char* weights : {"bending=1", "willmore=1", "mvs_cross=1"}) {
      const umbilic::Run run = judged(*generate_cage(name), weights, 100);
      for (const LevelReport& level : run.levels()) EXPECT_TRUE(level.credible) << name << ' ' << weights;
    }
  }
}

TEST(Embedded, are_connected_surfaces_with_less_willmore_energy_than_8_pi) {
  EXPECT_TRUE(judged(*generate_cage("torus"), "bending=1").energies().embedded);
  EXPECT_TRUE(judged(*generate_cage("cube"), "mvs_cross=1", 20).energies().embedded) << "whatever the functional";
  const EnergyReport two = judged(stress_cage("two cubes"), "bending=1").energies();
  EXPECT_NEAR(two.functionals[kWillmore], 8 * pi, 2e-3);
  EXPECT_FALSE(two.embedded);
  const EnergyReport frame = evaluate(*generate_cage("two-3"), CapKind::kSmooth, 0)->energies;
  EXPECT_GT(frame.functionals[kWillmore], 8 * pi);
  EXPECT_FALSE(frame.embedded) << "it is, but its energy does not prove it";
}

TEST(Embedded, are_not_surfaces_whose_energies_are_not_their_own) {
  for (const char* name : {"flat box", "plate 1 : 1e6"}) {
    const EnergyReport energies = evaluate(stress_cage(name), CapKind::kSmooth, 0)->energies;
    EXPECT_FALSE(energies.embedded) << name;
    EXPECT_FALSE(energies.credible()) << name;
  }
}

}  // namespace
}  // namespace umbilic::test
