// SPDX-License-Identifier: MIT
/// \file
/// Surfaces that are kept as one point of each orbit, and come back with their energies and their symmetry.
#include "driver/symmetric_cage.h"

#include <gtest/gtest.h>

#include <limits>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

umbilic::Run minimized(const auto& cage, int level, int iterations) {
  RunOptions options;
  options.weights = *weights_of("mvs_cross");
  options.last_level = level;
  options.max_iterations = iterations;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(1000)) {
  }
  return run;
}

TEST(SymmetricCage, of_the_orbit_points_of_a_run_has_its_energies_and_its_group) {
  for (const char* name : {"two-4", "tetrahedron-frame", "cube", "torus"}) {
    for (const int level : {0, 1}) {
      SCOPED_TRACE(name);
      const Cage cage = *generate_cage(name);
      const umbilic::Run run = minimized(cage, level, 5);
      const SymmetricCage again = *symmetric_cage(cage, level, run.orbit_points());
      EXPECT_EQ(again.cage.faces, run.control_mesh().faces);
      EXPECT_LT((again.cage.vertices - run.control_mesh().vertices).cwiseAbs().maxCoeff(), 1e-14);

      const umbilic::Run opened = minimized(again, 0, 0);
      EXPECT_EQ(opened.group().name, run.group().name);
      EXPECT_EQ(opened.group().order, run.group().order);
      const auto &before = run.energies().functionals, &after = opened.energies().functionals;
      for (int f = 0; f < kFunctionalCount; ++f) EXPECT_NEAR(after[f], before[f], 1e-12 * before[f]);
      EXPECT_LT((opened.orbit_points() - run.orbit_points()).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(SymmetricCage, needs_the_points_of_its_orbits) {
  const Cage cage = *generate_cage("two-3");
  Points points = minimized(cage, 1, 0).orbit_points();
  const std::string words = symmetric_cage(cage, 0, points).error().message;
  EXPECT_NE(words.find("one for each orbit of vertices at level 0"), std::string::npos) << words;
  EXPECT_EQ(symmetric_cage(cage, -1, points).error().message, "level -1: expected a number >= 0");
  EXPECT_NE(words.find("or 22, of all vertices"), std::string::npos) << words;
  points(2, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(symmetric_cage(cage, 1, points).error().message, "point 3 is not finite");
}

}  // namespace
}  // namespace umbilic
