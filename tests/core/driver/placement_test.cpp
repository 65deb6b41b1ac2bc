// SPDX-License-Identifier: MIT
/// \file
/// Runs and evaluations of cages of any size at any place have the digits that their input has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

umbilic::Run minimized(const Cage& cage, std::string_view functional, int level) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = level;
  options.max_iterations = 20;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(1000)) {
  }
  return run;
}

Cage scaled(Cage cage, int power) {
  cage.vertices = cage.vertices.unaryExpr([&](double x) { return std::ldexp(x, power); }).eval();
  return cage;
}

/// Its coordinates are integers, and remain so.
Cage cube_at(double offset) {
  Cage cage = *generate_cage("cube");
  cage.vertices.array() += offset;
  return cage;
}

TEST(AnyPlace, runs_of_scaled_cages_differ_by_the_scale_and_by_nothing_else) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    const Cage cage = *generate_cage("two-3");
    const umbilic::Run plain = minimized(cage, functional, 1);
    for (const int power : {-300, 300}) {
      const umbilic::Run run = minimized(scaled(cage, power), functional, 1);
      EXPECT_EQ(run.control_mesh().vertices, scaled(plain.control_mesh(), power).vertices);
      EXPECT_EQ(run.orbit_points(), scaled({plain.orbit_points(), {}}, power).vertices);
      EXPECT_EQ(run.energies().functionals, plain.energies().functionals);
      EXPECT_EQ(run.energies().area, std::ldexp(plain.energies().area, 2 * power));
      EXPECT_EQ(run.progress().gradient_norm, std::ldexp(plain.progress().gradient_norm, -power));
      const LimitMesh mesh = *run.limit_mesh(2), unit = *plain.limit_mesh(2);
      EXPECT_EQ(mesh.positions, scaled({unit.positions, {}}, power).vertices);
      EXPECT_EQ(mesh.curvatures(0, 0), std::ldexp(unit.curvatures(0, 0), -power));
      EXPECT_EQ(mesh.normals, unit.normals);
    }
  }
}

TEST(AnyPlace, energies_of_a_scaled_cage_are_the_same_to_the_last_bit_and_the_slope_has_its_scale) {
  const Cage cage = *generate_cage("tetrahedron-frame");
  const EnergyReport plain = evaluate(cage, CapKind::kSmooth, 1)->energies;
  const GradientReport slope = *check_gradient(cage, *weights_of("bending"), CapKind::kSmooth);
  for (const int power : {-300, 7, 300}) {
    const EnergyReport energies = evaluate(scaled(cage, power), CapKind::kSmooth, 1)->energies;
    EXPECT_EQ(energies.functionals, plain.functionals);
    EXPECT_EQ(energies.gaussian, plain.gaussian);
    const GradientReport here = *check_gradient(scaled(cage, power), *weights_of("bending"), CapKind::kSmooth);
    EXPECT_TRUE(here.ok);
    EXPECT_EQ(here.analytic, std::ldexp(slope.analytic, -power));
  }
  EXPECT_EQ(evaluate(scaled(cage, 600), CapKind::kSmooth, 1)->energies.area, std::numeric_limits<double>::infinity());
  EXPECT_EQ(evaluate(scaled(cage, -600), CapKind::kSmooth, 1)->energies.area, 0);
}

TEST(AnyPlace, a_cage_of_exact_coordinates_has_the_energies_that_it_has_at_the_origin) {
  const EnergyReport plain = evaluate(cube_at(0), CapKind::kSmooth, 2)->energies;
  for (const double offset : {1e6, -1e9, 1e12}) {
    const EnergyReport energies = evaluate(cube_at(offset), CapKind::kSmooth, 2)->energies;
    for (int i = 0; i < kFunctionalCount; ++i) {
      EXPECT_NEAR(energies.functionals[i], plain.functionals[i], 1e-12 * plain.functionals[i]) << offset;
    }
    EXPECT_NEAR(energies.area, plain.area, 1e-12 * plain.area);
  }
}

TEST(AnyPlace, the_mesh_that_a_distant_run_gives_has_the_energies_that_it_reports) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    for (const double offset : {1e3, 1e6, 1e9}) {
      Cage cage = *generate_cage("two-3");
      cage.vertices.array() += offset;
      const umbilic::Run run = minimized(cage, functional, 1);
      const EnergyReport again = evaluate(run.control_mesh(), CapKind::kSmooth, 0)->energies;
      for (int i = 0; i < kFunctionalCount; ++i) {
        EXPECT_NEAR(again.functionals[i], run.energies().functionals[i], 1e-12 * again.functionals[i]) << offset;
      }
    }
  }
}

TEST(AnyPlace, states_keep_their_place_and_size) {
  for (const double offset : {0., 1e5}) {
    Cage cage = *generate_cage("two-3");
    cage.vertices = (1e-3 * (cage.vertices.array() + offset)).matrix().eval();
    const umbilic::Run run = minimized(cage, "bending", 1);
    const umbilic::Run again = *umbilic::Run::create(cage, {.weights = *weights_of("bending")}, {}, run.state());
    const double rounding = 1e-3 * std::max(1e-14, 1e-15 * offset);
    EXPECT_LT((again.control_mesh().vertices - run.control_mesh().vertices).cwiseAbs().maxCoeff(), rounding) << offset;
    EXPECT_EQ(again.group().name, "D3h");
  }
}

/// Moves the coordinates by up to half a unit in the last place, by rounding them at the offset, and back.
TEST(InputRounding, tells_how_far_energies_of_a_rounded_cage_are_from_the_true_ones) {
  const Cage cage = minimized(*generate_cage("two-3"), "bending", 2).control_mesh();
  const EnergyReport truth = evaluate(cage, CapKind::kSmooth, 0)->energies;
  EXPECT_FALSE(truth.input_rounding) << "about the origin";
  for (const double offset : {1e5, 1e7, 1e9}) {
    Cage distant = cage;
    distant.vertices.array() += offset;
    const EnergyReport energies = evaluate(distant, CapKind::kSmooth, 0)->energies;
    for (int i = 0; i < kFunctionalCount; ++i) {
      const double change = std::abs(energies.functionals[i] / truth.functionals[i] - 1);
      // A random number against the largest of three like it: within a factor of ten either way, where the energies'
      // own digits show it.
      constexpr double kDigits = 1e-15;
      EXPECT_LT(change, 10 * energies.input_rounding->values[i] + kDigits) << kFunctionalNames[i] << " at " << offset;
      EXPECT_GT(10 * change + kDigits, energies.input_rounding->values[i] / 10)
          << kFunctionalNames[i] << " at " << offset;
    }
    EXPECT_GT(energies.input_rounding->values[kMvsCross], energies.input_rounding->values[kBending]);
  }
}

TEST(Evaluate, of_a_surface_that_shrinks_to_a_point_somewhere_says_so) {
  CageOptions options;
  options.major_segments = options.minor_segments = 10;
  Cage cage = *generate_cage("torus", options);
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) cage.vertices.row(10 * i + j) = cage.vertices.row(0).eval();
  }
  EXPECT_EQ(evaluate(cage, CapKind::kSmooth, 0).error().message,
            "the surface shrinks to a curve or a point somewhere: it has no energies");
}

}  // namespace
}  // namespace umbilic
