// SPDX-License-Identifier: MIT
/// \file
/// Runs of cages without symmetry: they converge in about as few evaluations as symmetric ones.
#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/run.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

/// Points that differ by up to so much, in each coordinate, from those of a cage of unit size leave no symmetry.
constexpr double kMoved = 0.12;

umbilic::Run finished(const Cage& cage, int last_level) {
  RunOptions options;
  options.weights = *parse_weights("mvs_cross=1");
  options.last_level = last_level;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(100)) {
  }
  return run;
}

TEST(UnsymmetricSlow, genus_2_cages_converge_in_few_evaluations_to_energies_no_higher_than_the_symmetric_one) {
  const Cage cage = *generate_cage("two-3");
  const umbilic::Run symmetric = finished(cage, 2);
  for (unsigned seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE(seed);
    Cage moved = cage;
    moved.vertices += kMoved * Random(seed).points(moved.vertices.rows());
    const umbilic::Run run = finished(moved, 2);
    ASSERT_EQ(run.group().order, 1);
    for (std::size_t i = 0; i < run.levels().size(); ++i) {
      const LevelReport& level = run.levels()[i];
      EXPECT_EQ(level.stop, StopReason::kConverged);
      EXPECT_EQ(level.metric, MetricChoice::kNewton);
      EXPECT_LE(level.evaluations, 150) << "level " << level.level;
      EXPECT_LE(level.energy_reported, 1.0001 * symmetric.levels()[i].energy_reported);
    }
  }
}

}  // namespace
}  // namespace umbilic::test
