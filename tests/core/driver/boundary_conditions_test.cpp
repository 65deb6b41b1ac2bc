// SPDX-License-Identifier: MIT
/// \file
/// Runs of open surfaces against closed forms and one-dimensional minimizations.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "cage/read.h"
#include "driver/boundary_rows.h"
#include "driver/equations.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "mesh/boundary.h"

namespace umbilic {
namespace {

umbilic::Run bounded(const Cage& cage, const char* functional, int last_level, const Constraints& constraints = {},
                     double tolerance = 1e-8) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = last_level;
  options.tolerance = tolerance;
  Result<umbilic::Run> created = umbilic::Run::create(cage, options, constraints);
  EXPECT_TRUE(created) << (created ? "" : created.error().message);
  umbilic::Run run = std::move(created).value();
  while (!run.step(1000)) {
  }
  return run;
}

Constraints at_boundary(BoundaryCondition condition) {
  Constraints constraints;
  constraints.boundary = BoundaryConditions{condition, {}};
  return constraints;
}

/// A grid of n x n quads over [-1, 1]^2, with heights that undulate.
Cage undulating_grid(int n, double height) {
  std::string text;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = 2. * i / n - 1, y = 2. * j / n - 1;
      text += "v " + std::to_string(x) + " " + std::to_string(y) + " " +
              std::to_string(height * std::sin(3 * x) * std::cos(2 * y + 1)) + "\n";
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i + 1;
      for (const int corner : {v, v + 1, v + n + 2, v + n + 1})
        text += (corner == v ? "f " : " ") + std::to_string(corner);
      text += "\n";
    }
  }
  return read_checked_cage(text).value().cage;
}

/// The Willmore energies of surfaces of revolution over [-1, 1] with radius alpha and slope 0 at both ends, by spectral
/// minimization of their profiles. A circle of 32 points is off by 4e-6 of it (held as a spline, it is data).
TEST(BoundaryConditions, clamped_surfaces_of_revolution_have_their_minimum) {
  for (const auto& [alpha, expected] : {std::pair{0.5, 5.8607471}, {1., 3.1239888}, {2., 1.5702457}}) {
    CageOptions options;
    options.radius = alpha;
    options.major_segments = 32;
    const umbilic::Run run = bounded(*generate_cage("cylinder", options), "willmore", 0);
    EXPECT_NEAR(run.energies().functionals[kWillmore], expected, 5e-4 * expected) << alpha;
    EXPECT_EQ(run.result().stop, StopReason::kConverged) << alpha;
  }
}

TEST(BoundaryConditions, parts_of_a_sphere_are_found_from_their_boundary_tangents) {
  for (const double theta : {30., 90.}) {
    CageOptions options;
    options.half_angle = theta;
    Cage cage = *generate_cage("spherical-cap", options);
    const umbilic::Run run = bounded(cage, "willmore", 0);
    const double expected = 2 * std::numbers::pi * (1 - std::cos(theta * std::numbers::pi / 180));
    EXPECT_NEAR(run.energies().functionals[kWillmore], expected, 1e-3 * expected) << theta;
  }
}

TEST(BoundaryConditions, catenoids_are_minima_of_bending) {
  CageOptions options;
  options.height = 1;
  const umbilic::Run run = bounded(*generate_cage("catenoid", options), "bending", 0);
  const double expected = 8 * std::numbers::pi * std::tanh(0.5);
  EXPECT_NEAR(run.energies().functionals[kBending], expected, 1e-3 * expected);
}

/// The points of C, D and E at the boundary, of the control points and of the cage's own.
double largest_residual(const umbilic::Run& run, const Cage& cage, const Constraints& constraints, int level) {
  RefinedCage mesh = refine(*prepare(cage, level, true, constraints), level);
  const Points control =
      mesh.placement.to_unit(Coordinates(mesh.mesh, mesh.symmetry).control_from_orbits(run.orbit_points()));
  const PinRows rows = equations_of(mesh);
  return (rows.rows.matrix * Eigen::Map<const Eigen::VectorXd>(control.data(), control.size()) - rows.rows.right)
      .cwiseAbs()
      .maxCoeff();
}

TEST(BoundaryConditions, ask_nothing_of_a_free_boundary_that_has_no_ghosts_yet) {
  Constraints constraints = at_boundary(BoundaryCondition::kFree);
  constraints.pins.resize(1);
  constraints.pins[0].vertex = 7;
  const RefinedCage cage = *prepare(undulating_grid(4, 0.3), 1, true, constraints);
  EXPECT_TRUE(boundary_rows(cage.boundary, cage.mesh).empty());
  EXPECT_EQ(equations_of(cage).rows.count(), 3);
}

TEST(BoundaryConditions, are_held_to_rounding_on_every_level_at_corners_as_well) {
  const Cage grid = undulating_grid(4, 0.3);
  for (const auto condition : {BoundaryCondition::kPosition, BoundaryCondition::kTangent}) {
    for (const int level : {1, 2}) {
      const Constraints constraints = at_boundary(condition);
      const umbilic::Run run = bounded(grid, "bending", level, constraints, 1e-4);
      EXPECT_LT(largest_residual(run, grid, constraints, level), 1e-12);
      EXPECT_GT(run.constraints()->deviation, 1e-3);
    }
  }
}

/// Held less, a surface can only get better.
TEST(BoundaryConditions, cost_the_more_the_more_they_hold) {
  const Cage grid = undulating_grid(4, 0.3);
  const auto energy = [&](BoundaryCondition condition) {
    return bounded(grid, "bending", 1, at_boundary(condition)).result().energy;
  };
  const double position = energy(BoundaryCondition::kPosition), tangent = energy(BoundaryCondition::kTangent);
  EXPECT_LT(position, tangent);
  EXPECT_LT(energy(BoundaryCondition::kFree), 0.01 * position);
}

TEST(BoundaryConditions, of_curvature_need_data) {
  const std::string words = umbilic::Run::create(undulating_grid(3, 0.1), RunOptions{.weights = *weights_of("bending")},
                                                 at_boundary(BoundaryCondition::kCurvature))
                                .error()
                                .message;
  EXPECT_NE(words.find("says nothing of the curvature across its boundary at vertex"), std::string::npos) << words;
}

TEST(BoundaryConditions, of_curvature_are_held_to_rounding_at_the_corners_of_a_polygon_with_a_saddle) {
  for (const int sides : {3, 8}) {
    const Cage saddle = *generate_cage("n-sided", {.major_segments = 4, .sides = sides, .rise = 0.25});
    const Constraints constraints = at_boundary(BoundaryCondition::kCurvature);
    const umbilic::Run run = bounded(saddle, "mvs_cross", 1, constraints, 1e-4);
    EXPECT_LT(largest_residual(run, saddle, constraints, 1), 1e-12);
    EXPECT_GT(run.constraints()->deviation, 1e-3);
  }
}

TEST(BoundaryConditions, of_curvature_have_their_data_where_the_faces_at_the_boundary_are_held) {
  const Cage grid = undulating_grid(6, 0.3);
  Constraints constraints = at_boundary(BoundaryCondition::kCurvature);
  constraints.hold.emplace();
  for (int f = 0; f < 36; ++f) {
    const int i = f % 6, j = f / 6;
    if (i == 0 || j == 0 || i == 5 || j == 5) constraints.hold->faces.push_back(f + 1);
  }
  const umbilic::Run run = bounded(grid, "bending", 1, constraints);
  EXPECT_LT(largest_residual(run, grid, constraints, 1), 1e-12);
  EXPECT_GT(run.constraints()->deviation, 0.01) << "the rest is free";
  constraints.hold->faces.pop_back();  // a corner
  const std::string words =
      umbilic::Run::create(grid, RunOptions{.weights = *weights_of("bending")}, constraints).error().message;
  EXPECT_NE(words.find("boundary at vertex"), std::string::npos) << words;
}

/// The cylinder's own curvature at its boundaries, and nothing else, gives the cylinder back from a disturbed one. What
/// is left is the error of the circle of the boundary, a spline; how much of it depends on the parametrization, of
/// which there are several local minima.
TEST(BoundaryConditions, of_curvature_find_the_cylinder_for_mvs_cross) {
  double before = 0;
  for (const int around : {10, 20}) {
    CageOptions options;
    options.major_segments = around;
    options.minor_segments = around / 2;
    const Cage cage = *generate_cage("cylinder", options);
    Cage disturbed = cage;
    for (Eigen::Index v = 0; v < cage.vertices.rows(); ++v) {
      if (std::abs(cage.vertices(v, 2)) > 1 - 1.5 * (4. / around)) continue;  // C, D and E stay
      for (int c = 0; c < 3; ++c)
        disturbed.vertices(v, c) += 0.05 * std::sin(1. + 7. * static_cast<double>(v) + 3. * c);
    }
    const umbilic::Run run = bounded(disturbed, "mvs_cross", 0, at_boundary(BoundaryCondition::kCurvature), 1e-5);
    const double floor = run.result().energy_reported;
    EXPECT_LT(floor, 0.05 * evaluate(disturbed, CapKind::kSmooth, 0)->energies.functionals[kMvsCross]);
    if (before > 0) {
      EXPECT_LT(floor, before / 3);
    }
    before = floor;
  }
}

TEST(BoundaryConditions, of_single_loops_and_stretches_replace_the_common_one) {
  const Cage grid = undulating_grid(3, 0.1);
  const PolygonMesh mesh(grid);
  BoundaryConditions conditions{BoundaryCondition::kTangent, {{1, 1, 4, BoundaryCondition::kFree}}};
  const std::vector<BoundaryCondition> at = *boundary_conditions(conditions, mesh, {});
  int free = 0, held = 0;
  for (int h = 0; h < mesh.surface_halfedge_count(); ++h) {
    if (!mesh.is_boundary(h)) continue;
    ++(at[h] == BoundaryCondition::kFree ? free : held);
  }
  EXPECT_EQ(free, 3);  // from vertex 1 along the first row to vertex 4
  EXPECT_EQ(held, 9);
  const auto message = [&](const LoopCondition& loop) {
    return boundary_conditions({BoundaryCondition::kTangent, {loop}}, mesh, {}).error().message;
  };
  EXPECT_EQ(message({2, {}, {}, BoundaryCondition::kFree}),
            "constraints.boundary.loops[0].loop: there is no boundary 2; the cage has 1");
  EXPECT_EQ(message({1, 6, 1, BoundaryCondition::kFree}),
            "constraints.boundary.loops[0].from: vertex 6 is not on that boundary");
  EXPECT_EQ(message({1, 1, {}, BoundaryCondition::kFree}),
            "constraints.boundary.loops[0].from: a stretch needs from and to");
  EXPECT_EQ(boundary_conditions(conditions, PolygonMesh(*generate_cage("cube")), {}).error().message,
            "constraints.boundary.loops[0]: the cage is closed");
}

TEST(BoundaryConditions, are_the_same_where_a_run_goes_on_from_its_state) {
  const Cage grid = undulating_grid(4, 0.3);
  const umbilic::Run run = bounded(grid, "bending", 1, {}, 1e-4);
  RunOptions options;
  options.weights = *weights_of("bending");
  const umbilic::Run again = *umbilic::Run::create(grid, options, {}, run.state());
  EXPECT_NEAR(again.energies().functionals[kBending], run.energies().functionals[kBending], 1e-12);
}

}  // namespace
}  // namespace umbilic
