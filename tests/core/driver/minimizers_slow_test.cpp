// SPDX-License-Identifier: MIT
/// \file
/// Minimizers whose energies mathematics knows, and energies that must not depend on the cage.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

using std::numbers::pi;
/// Lawson's xi_{2,1}: 4 W - 8 pi (1 - g) with W = 21.908514 (Hsu, Kusner & Sullivan 1992).
constexpr double kGenusTwoBending = 112.7668;
constexpr double kCliffordBending = 8 * pi * pi;

std::vector<LevelReport> minimize(const Cage& cage, std::string_view weights, int first, int last,
                                  int max_iterations = 1000) {
  RunOptions options;
  options.weights = *parse_weights(weights);
  options.first_level = first;
  options.last_level = last;
  options.max_iterations = max_iterations;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(1000)) {
  }
  return run.levels();
}

TEST(MinimizersSlow, gauss_bonnet_holds_on_every_generated_frame) {
  for (const CageName& name : cage_names()) {
    if (name.open) continue;
    for (const FrameFamily family : {FrameFamily::kHub, FrameFamily::kFlag}) {
      Cage cage = *generate_cage(name.name, {.family = family});
      const int genus = validate(cage)->genus;
      const EvaluationReport report = *evaluate(cage, CapKind::kSmooth, 3);
      const double unit = 4 * pi * std::max(1, std::abs(1 - genus));
      EXPECT_NEAR(report.energies.gaussian, 4 * pi * (1 - genus), 1e-4 * unit) << name.name;
    }
  }
}

TEST(MinimizersSlow, bending_of_fat_and_thin_tori_becomes_the_clifford_torus) {
  for (const double ratio : {0.3, 0.85}) {
    const auto levels = minimize(*generate_cage("torus", {.ratio = ratio}), "bending=1", 0, 2);
    EXPECT_NEAR(levels.back().energy_reported, kCliffordBending, 1e-5 * kCliffordBending) << ratio;
    EXPECT_GT(levels.back().energy_reported, kCliffordBending * (1 - 1e-8)) << ratio;
  }
}

TEST(MinimizersSlow, mvs_of_a_torus_falls_towards_0) {
  const auto levels = minimize(*generate_cage("torus"), "mvs=1", 0, 2, 300);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_LT(levels[i].energy_reported, 0.25 * levels[i - 1].energy_reported);
  }
}

TEST(MinimizersSlow, both_cages_of_genus_two_bend_like_lawsons_surface_and_never_below_it) {
  for (const FrameFamily family : {FrameFamily::kHub, FrameFamily::kFlag}) {
    const auto levels = minimize(*generate_cage("two-3", {.family = family}), "bending=1", 0, 2);
    EXPECT_LT(levels.back().energy_reported, kGenusTwoBending * 1.001);
    for (const LevelReport& level : levels) EXPECT_GT(level.energy_reported, kGenusTwoBending * (1 - 1e-5));
  }
}

TEST(MinimizersSlow, a_cube_becomes_a_sphere_whose_mvs_cross_falls_towards_0) {
  const auto bending = minimize(*generate_cage("cube"), "bending=1", 0, 3);
  EXPECT_NEAR(bending.back().energy_reported, 8 * pi, 1e-3);
  EXPECT_GT(bending.back().energy_reported, 8 * pi * (1 - 1e-6));
  const auto variation = minimize(*generate_cage("cube"), "mvs_cross=1", 0, 3, 300);
  for (std::size_t i = 1; i < variation.size(); ++i) {
    EXPECT_LT(variation[i].energy_reported, variation[i - 1].energy_reported);
  }
}

TEST(MinimizersSlow, mvs_cross_of_genus_two_does_not_depend_on_the_cage) {
  const auto flag = minimize(*generate_cage("two-3"), "mvs_cross=1", 0, 3, 700);
  ASSERT_EQ(flag[2].level, 2);
  EXPECT_LT(flag[2].energy_reported, 4350);
  EXPECT_LE(flag[2].evaluations, 1000);
  const auto hub = minimize(*generate_cage("two-3", {.family = FrameFamily::kHub}), "mvs_cross=1", 0, 3, 700);
  ASSERT_EQ(hub.back().level, 3);
  EXPECT_NEAR(hub.back().energy_reported, flag.back().energy_reported, 0.02 * flag.back().energy_reported);
}

}  // namespace
}  // namespace umbilic
