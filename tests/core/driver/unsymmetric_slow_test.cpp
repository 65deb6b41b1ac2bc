// SPDX-License-Identifier: MIT
/// \file
/// Runs of cages without symmetry, whose parametrization nothing holds.
#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/run.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

/// Points that differ by up to so much, in each coordinate, from those of a cage of unit size leave no symmetry.
constexpr double kMoved = 0.12;

TEST(UnsymmetricSlow, genus_2_cages_converge_to_energies_no_higher_than_the_symmetric_one) {
  RunOptions options;
  options.weights = *parse_weights("mvs_cross=1");
  Cage cage = *generate_cage("two-3");
  umbilic::Run symmetric = *umbilic::Run::create(cage, options);
  while (!symmetric.step(100)) {
  }
  cage.vertices += kMoved * Random(1).points(cage.vertices.rows());
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(100)) {
  }
  ASSERT_EQ(run.group().order, 1);
  for (std::size_t i = 0; i < run.levels().size(); ++i) {
    const LevelReport& level = run.levels()[i];
    EXPECT_EQ(level.stop, StopReason::kConverged);
    EXPECT_LE(level.iterations, options.max_iterations / 2) << "level " << level.level;
    EXPECT_LE(level.energy_reported, 1.0001 * symmetric.levels()[i].energy_reported);
  }
}

}  // namespace
}  // namespace umbilic::test
