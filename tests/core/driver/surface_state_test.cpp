// SPDX-License-Identifier: MIT
/// \file
/// Surfaces that are kept as one point of each orbit, and come back with their energies and their symmetry.
#include "driver/surface_state.h"

#include <gtest/gtest.h>

#include <limits>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

umbilic::Run minimized(const Cage& cage, int level, int iterations, const std::optional<SurfaceState>& start = {}) {
  RunOptions options;
  options.weights = *weights_of("mvs_cross");
  options.last_level = level;
  options.max_iterations = iterations;
  umbilic::Run run = *umbilic::Run::create(cage, options, {}, start);
  while (!run.step(1000)) {
  }
  return run;
}

TEST(SurfaceState, of_a_run_has_its_energies_and_its_group) {
  for (const char* name : {"two-4", "tetrahedron-frame", "cube", "torus"}) {
    for (const int level : {0, 1}) {
      SCOPED_TRACE(name);
      const Cage cage = *generate_cage(name);
      const umbilic::Run run = minimized(cage, level, 5);
      const umbilic::Run opened = minimized(cage, 0, 0, run.state());
      EXPECT_EQ(opened.control_mesh().faces, run.control_mesh().faces);
      EXPECT_LT((opened.control_mesh().vertices - run.control_mesh().vertices).cwiseAbs().maxCoeff(), 1e-14);
      EXPECT_EQ(opened.group().name, run.group().name);
      EXPECT_EQ(opened.group().order, run.group().order);
      const auto &before = run.energies().functionals, &after = opened.energies().functionals;
      for (int f = 0; f < kFunctionalCount; ++f) EXPECT_NEAR(after[f], before[f], 1e-12 * before[f]);
      EXPECT_LT((opened.orbit_points() - run.orbit_points()).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(SurfaceState, of_a_run_with_less_symmetry_than_its_cage_comes_back) {
  const Cage cage = *generate_cage("tetrahedron-frame");
  SurfaceState less{0, cage.vertices};
  less.points.col(2) *= 1.1;
  const umbilic::Run run = minimized(cage, 1, 5, less);
  ASSERT_EQ(run.group().name, "D2d");
  const umbilic::Run opened = minimized(cage, 0, 0, run.state());
  EXPECT_EQ(opened.group().name, "D2d");
  EXPECT_LT((opened.control_mesh().vertices - run.control_mesh().vertices).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(SurfaceState, needs_the_points_of_its_orbits) {
  const Cage cage = *generate_cage("two-3");
  Points points = minimized(cage, 1, 0).orbit_points();
  const auto message = [&](int level) {
    return umbilic::Run::create(cage, RunOptions{.weights = *weights_of("bending")}, {}, SurfaceState{level, points})
        .error()
        .message;
  };
  const std::string words = message(0);
  EXPECT_NE(words.find("one for each orbit of vertices at level 0"), std::string::npos) << words;
  EXPECT_EQ(message(-1), "start.level: -1 is negative");
  EXPECT_NE(words.find("or 22, of all vertices"), std::string::npos) << words;
  points(2, 1) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(1), "start: point 3 is not finite");
}

}  // namespace
}  // namespace umbilic
