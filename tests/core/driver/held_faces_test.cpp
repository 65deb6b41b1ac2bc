// SPDX-License-Identifier: MIT
/// \file
/// Held faces: what stays stays to the last bit, and the rest becomes the minimizer that joins it.
#include "driver/held_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "driver/surface_state.h"
#include "mesh/subdivision.h"

namespace umbilic {
namespace {

constexpr double kPi = std::numbers::pi;

FaceSelection faces(std::vector<int> numbers) { return {{}, std::move(numbers)}; }

Constraints holding(std::vector<int> numbers) { return {faces(std::move(numbers)), {}}; }

RunOptions held_options(const char* functional, int last_level, int iterations = 1000) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = last_level;
  options.max_iterations = iterations;
  return options;
}

umbilic::Run held_run(const Cage& cage, const RunOptions& options, const Constraints& constraints) {
  umbilic::Run run = *umbilic::Run::create(cage, options, constraints);
  while (!run.step(1000)) {
  }
  return run;
}

/// The cube's cage after `steps` Catmull-Clark steps, each followed by moving all points onto the unit sphere: its
/// surface is nearly the sphere.
Cage nearly_a_sphere(int steps) {
  PolygonMesh mesh(*generate_cage("cube"));
  Points points = generate_cage("cube")->vertices;
  for (int i = 0; i < steps; ++i) {
    Refinement finer = catmull_clark(mesh);
    points = (finer.stencil * points).rowwise().normalized();
    mesh = std::move(finer.mesh);
  }
  return to_cage(mesh, points);
}

/// The numbers of the faces whose corners all have z >= 0.
std::vector<int> upper_faces(const Cage& cage) {
  std::vector<int> numbers;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    bool upper = true;
    for (const int v : cage.faces[f]) upper = upper && cage.vertices(v, 2) > -1e-9;
    if (upper) numbers.push_back(static_cast<int>(f) + 1);
  }
  return numbers;
}

/// Pushes the points below z = -0.2 around, always in the same way.
void disturb_below(Cage& cage, double by) {
  for (Eigen::Index v = 0; v < cage.vertices.rows(); ++v) {
    if (cage.vertices(v, 2) > -0.2) continue;
    for (int c = 0; c < 3; ++c) cage.vertices(v, c) += by * std::sin(1.0 + 7.0 * static_cast<double>(v) + 3.0 * c);
  }
}

TEST(HeldFaces, keep_their_control_points_to_the_last_bit_on_every_level) {
  Cage cage = nearly_a_sphere(2);
  disturb_below(cage, 0.1);
  cage.vertices *= 1024;
  const Constraints constraints = holding(upper_faces(cage));
  for (const int level : {0, 1}) {
    const umbilic::Run run = held_run(cage, held_options("bending", level, 5), constraints);
    RefinedCage own = refine(*prepare(cage, level, false, constraints), level);
    const HeldPoints held = held_points(own, CapKind::kSmooth);
    const Points expected = own.placement.back(own.own), actual = run.control_mesh().vertices;
    int count = 0, moved = 0;
    for (Eigen::Index v = 0; v < expected.rows(); ++v) {
      if (!held.held[v]) {
        moved += actual.row(v) != expected.row(v);
        continue;
      }
      ++count;
      EXPECT_EQ(actual.row(v), expected.row(v));
    }
    EXPECT_GT(count, expected.rows() / 3);
    EXPECT_GT(moved, expected.rows() / 4);
  }
}

/// The held half keeps a fault of its own; the rest adds almost nothing.
TEST(HeldFacesSlow, let_the_rest_of_a_disturbed_sphere_return_to_the_sphere) {
  Cage cage = nearly_a_sphere(3);
  const Constraints constraints = holding(upper_faces(cage));
  const double fault = evaluate(cage, CapKind::kSmooth, 0)->energies.functionals[kBending] - 8 * kPi;
  disturb_below(cage, 0.05);
  const umbilic::Run run = held_run(cage, held_options("bending", 0), constraints);
  EXPECT_NE(run.result().stop, StopReason::kLineSearchStalled);
  const EnergyReport& energies = run.energies();
  EXPECT_NEAR(energies.functionals[kBending], 8 * kPi, 1e-4 * 8 * kPi + std::abs(fault));
  ASSERT_TRUE(energies.free);
  EXPECT_LT(energies.free->functionals[kBending], energies.functionals[kBending]);
  EXPECT_LT(energies.free->area, energies.area);
}

TEST(HeldFaces, fix_the_area_factor_of_third_order_functionals_to_that_of_the_start) {
  Cage cage = nearly_a_sphere(2);
  disturb_below(cage, 0.05);
  const Constraints constraints = holding(upper_faces(cage));
  const umbilic::Run run = held_run(cage, held_options("mvs_cross", 0, 3), constraints);
  const double own_area = evaluate(cage, CapKind::kSmooth, 0)->energies.area;
  EXPECT_NEAR(run.energies().free->area_factor, own_area, 1e-12 * own_area);
  EXPECT_NE(run.energies().area, own_area);
}

TEST(HeldFaces, give_a_functional_with_the_square_of_the_area_the_square_of_that_constant) {
  Cage cage = nearly_a_sphere(2);
  disturb_below(cage, 0.05);
  const umbilic::Run run = held_run(cage, held_options("curvedness_variation", 0, 3), holding(upper_faces(cage)));
  const EnergyReport& energies = run.energies();
  // What is minimized, by the minimizing rule, is what is reported of the free faces.
  const double minimized = energies.free->functionals[kCurvednessVariation];
  EXPECT_LT(energies.quadrature_error, 0.05 * minimized);
  EXPECT_NEAR(run.result().energy_reported, minimized, 1e-12 * minimized);
  EXPECT_GT(std::abs(energies.free->area_factor / energies.area - 1), 1e-4) << "it is not the area";
}

TEST(HeldFaces, of_what_is_free_tell_the_complement) {
  const Cage cage = nearly_a_sphere(1);
  const std::vector<int> upper = upper_faces(cage);
  std::vector<int> others;
  for (int f = 1; f <= static_cast<int>(cage.faces.size()); ++f) {
    if (std::find(upper.begin(), upper.end(), f) == upper.end()) others.push_back(f);
  }
  EXPECT_EQ(*held_faces(cage, holding(upper)), *held_faces(cage, {{}, faces(others)}));
}

TEST(HeldFaces, are_named_by_the_groups_of_the_cage) {
  Cage cage = nearly_a_sphere(1);
  cage.groups = {{"top", {0, 1, 2}}, {"rest", {3, 4}}};
  const Constraints constraints{FaceSelection{{"top"}, {5}}, {}};
  const std::vector<bool> held = *held_faces(cage, constraints);
  EXPECT_EQ(std::count(held.begin(), held.end(), true), 4);
  const auto message = [&](const FaceSelection& selection) {
    return held_faces(cage, {selection, {}}).error().message;
  };
  EXPECT_EQ(message({{"top", "tail"}, {}}),
            "constraints.hold.groups[1]: there is no group 'tail'; the cage has 'top', 'rest'");
  EXPECT_EQ(message({{}, {1, 25}}), "constraints.hold.faces[1]: there is no face 25; the cage has 24, numbered from 1");
  EXPECT_EQ(held_faces(cage, {{}, FaceSelection{}}).error().message,
            "constraints: all faces are held; nothing is free");
}

TEST(HeldFaces, reduce_the_symmetry_to_the_part_that_keeps_them) {
  const Cage cage = nearly_a_sphere(2);
  const umbilic::Run free = *umbilic::Run::create(cage, held_options("bending", 0));
  EXPECT_EQ(free.group().name, "Oh");
  const umbilic::Run half = *umbilic::Run::create(cage, held_options("bending", 0), holding(upper_faces(cage)));
  EXPECT_EQ(half.group().name, "C4v");
  EXPECT_EQ(half.group().order, 8);
}

/// A mirror image that holds only within the tolerance of the search would have to move held points.
TEST(HeldFaces, keep_no_symmetry_that_would_move_them) {
  Cage cage = nearly_a_sphere(2);
  cage.vertices(0, 0) += 1e-7;
  const std::vector<int> upper = upper_faces(cage);
  EXPECT_EQ(umbilic::Run::create(cage, held_options("bending", 0))->group().name, "Oh");
  EXPECT_EQ(umbilic::Run::create(cage, held_options("bending", 0), holding(upper))->group().order, 1);
}

TEST(HeldFaces, are_the_same_where_a_run_goes_on_from_its_state) {
  Cage cage = nearly_a_sphere(2);
  disturb_below(cage, 0.05);
  const Constraints constraints = holding(upper_faces(cage));
  const umbilic::Run run = held_run(cage, held_options("mvs_cross", 0, 4), constraints);
  const umbilic::Run again = *umbilic::Run::create(cage, held_options("mvs_cross", 0), constraints, run.state());
  EXPECT_EQ(again.control_mesh().vertices, run.control_mesh().vertices);
  EXPECT_EQ(again.energies().free->functionals, run.energies().free->functionals);
}

/// With and without its symmetry, a surface has one minimum.
TEST(HeldFaces, give_the_same_minimum_with_and_without_symmetry) {
  Cage cage = nearly_a_sphere(2);
  for (Eigen::Index v = 0; v < cage.vertices.rows(); ++v) {
    if (cage.vertices(v, 2) < -0.2) cage.vertices.row(v) *= 1.2;
  }
  const Constraints constraints = holding(upper_faces(cage));
  RunOptions options = held_options("bending", 0);
  options.tolerance = 1e-9;
  const umbilic::Run symmetric = held_run(cage, options, constraints);
  EXPECT_EQ(symmetric.group().order, 8);
  options.symmetry = false;
  const umbilic::Run free = held_run(cage, options, constraints);
  EXPECT_EQ(free.group().order, 1);
  EXPECT_NEAR(symmetric.result().energy, free.result().energy, 1e-6 * free.result().energy);
}

}  // namespace
}  // namespace umbilic
