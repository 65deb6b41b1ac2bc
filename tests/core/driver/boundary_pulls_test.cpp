// SPDX-License-Identifier: MIT
/// \file
/// How strongly boundaries pull, against differences of minimal energies and against rigid motions of everything.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <tuple>

#include "cage/generate.h"
#include "driver/boundary_rows.h"
#include "driver/run.h"
#include "driver/surface.h"

namespace umbilic {
namespace {

using Motion = Eigen::Transform<double, 3, Eigen::Isometry>;

Motion motion(const Vector3& shift, const Vector3& turn, const Vector3& center) {
  const double angle = turn.norm();
  const Vector3 axis = angle > 0 ? Vector3(turn / angle) : Vector3::UnitX();
  return Motion(Eigen::Translation3d(center + shift) * Eigen::AngleAxisd(angle, axis) * Eigen::Translation3d(-center));
}

/// Moves the control points on which what a boundary holds depends.
Cage with_moved_loop(Cage cage, std::size_t loop, const Motion& by) {
  const RefinedCage prepared = *prepare(cage, 0, false);
  const std::vector<int> loop_of = [&] {
    std::vector<int> of(prepared.mesh.vertex_count(), -1);
    const std::vector<std::vector<int>> loops = numbered_loops(prepared.mesh);
    for (const int h : loops[loop]) of[prepared.mesh.origin(h)] = static_cast<int>(loop);
    return of;
  }();
  std::set<int> points;
  for (const PointRow& row : boundary_rows(prepared.boundary, prepared.mesh)) {
    if (loop_of[row.vertex] >= 0) points.insert(row.points.begin(), row.points.end());
  }
  for (const int v : points) cage.vertices.row(v) = (by * Vector3(cage.vertices.row(v))).transpose();
  return cage;
}

Run minimized(const Cage& cage, const char* functional, BoundaryCondition condition) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = 0;
  options.tolerance = 1e-12;
  options.max_iterations = 1000;
  options.metric = MetricChoice::kHessian;
  Constraints constraints;
  constraints.boundary = BoundaryConditions{condition, {}};
  Run run = *Run::create(cage, options, constraints);
  while (!run.step(1000)) {
  }
  return run;
}

/// A tube of two circles that are neither parallel nor coaxial, four units wide.
Cage bent_tube() {
  CageOptions options;
  options.major_segments = 8;
  options.minor_segments = 4;
  options.height = 1.2;
  Cage cage = *generate_cage("cylinder", options);
  cage.vertices *= 4;  // lengths of the cage are not those of its unit coordinates
  return with_moved_loop(cage, 1, motion({0.8, -0.4, 0.4}, {0.1, 0.2, 0.05}, {0, 0, 2.4}));
}

Vector3 vector(const std::array<double, 3>& entries) { return Eigen::Map<const Vector3>(entries.data()); }

/// The constant factor of third-order functionals, which is the cage's: it is no part of what pulls.
double area_factor(const Run& run) { return run.energies().free ? run.energies().free->area_factor : 1; }

class BoundaryPulls : public testing::TestWithParam<std::tuple<const char*, BoundaryCondition>> {};

/// Of two dozen runs like the one of the other test.
class BoundaryPullsSlow : public BoundaryPulls {};

TEST_P(BoundaryPullsSlow, are_derivatives_of_the_minimal_energy_by_moving_and_turning_a_loop) {
  const char* const functional = std::get<0>(GetParam());
  const BoundaryCondition condition = std::get<1>(GetParam());
  const Cage cage = bent_tube();
  const umbilic::Run run = minimized(cage, functional, condition);
  const HeldBoundaryReport loop = run.constraints()->boundaries.at(1);
  const Vector3 center = vector(loop.center), pull = vector(loop.pull), moment = vector(loop.moment);
  EXPECT_GT(loop.strength, 0.1);
  EXPECT_GT(moment.norm(), 0.05);
  EXPECT_GE(loop.total, loop.strength);
  const double factor = area_factor(run);
  const auto energy = [&](const Vector3& shift, const Vector3& turn) {
    const umbilic::Run moved = minimized(with_moved_loop(cage, 1, motion(shift, turn, center)), functional, condition);
    return moved.result().energy * factor / area_factor(moved);
  };
  // Of fourth order in the step.
  const auto slope = [](const auto& f, double h) { return (8 * (f(h) - f(-h)) - f(2 * h) + f(-2 * h)) / (12 * h); };
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 along = Vector3::Unit(axis), none = Vector3::Zero();
    EXPECT_NEAR(pull[axis], slope([&](double t) { return energy(t * along, none); }, 0.002), 1e-4 * loop.strength);
    EXPECT_NEAR(moment[axis], slope([&](double t) { return energy(none, t * along); }, 0.0005), 1e-4 * moment.norm());
  }
}

/// The energy does not change when everything is moved.
TEST_P(BoundaryPulls, and_their_moments_balance) {
  const char* const functional = std::get<0>(GetParam());
  const BoundaryCondition condition = std::get<1>(GetParam());
  const ConstraintsReport report = *minimized(bent_tube(), functional, condition).constraints();
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  double scale = 0;
  ASSERT_EQ(report.boundaries.size(), 2u);
  for (const HeldBoundaryReport& loop : report.boundaries) {
    force += vector(loop.pull);
    moment += vector(loop.moment) + vector(loop.center).cross(vector(loop.pull));
    scale += loop.strength;
  }
  EXPECT_LT(force.norm(), 1e-6 * scale);
  EXPECT_LT(moment.norm(), 1e-5 * scale);
}

/// With its position alone held, the minima of a third-order functional are not isolated enough for differences.
const auto kEachCondition = testing::Values(
    std::tuple{"bending", BoundaryCondition::kPosition}, std::tuple{"bending", BoundaryCondition::kTangent},
    std::tuple{"bending", BoundaryCondition::kCurvature}, std::tuple{"mvs_cross", BoundaryCondition::kTangent},
    std::tuple{"mvs_cross", BoundaryCondition::kCurvature});
INSTANTIATE_TEST_SUITE_P(OfConditions, BoundaryPulls, kEachCondition);
INSTANTIATE_TEST_SUITE_P(OfConditions, BoundaryPullsSlow, kEachCondition);

TEST(BoundaryPulls, of_free_loops_are_not_reported) {
  Constraints constraints;
  constraints.boundary = BoundaryConditions{BoundaryCondition::kFree, {{2, {}, {}, BoundaryCondition::kTangent}}};
  RunOptions options;
  options.weights = *weights_of("bending");
  const umbilic::Run run = *umbilic::Run::create(bent_tube(), options, constraints);
  const std::vector<HeldBoundaryReport> boundaries = run.constraints()->boundaries;
  ASSERT_EQ(boundaries.size(), 1u);
  EXPECT_EQ(boundaries[0].boundary, 2);
}

/// A refined mesh numbers its loops as the cage does.
TEST(BoundaryPulls, are_those_of_the_same_loop_on_the_next_level) {
  Constraints constraints;
  constraints.boundary = BoundaryConditions{BoundaryCondition::kFree, {{2, {}, {}, BoundaryCondition::kTangent}}};
  RunOptions options;
  options.weights = *weights_of("bending");
  std::vector<Vector3> centers;
  for (const int level : {0, 1}) {
    options.first_level = options.last_level = level;
    const ConstraintsReport report = *umbilic::Run::create(bent_tube(), options, constraints)->constraints();
    EXPECT_EQ(report.boundaries.at(0).boundary, 2);
    centers.push_back(vector(report.boundaries.at(0).center));
  }
  EXPECT_LT((centers[0] - centers[1]).norm(), 1e-12);
  EXPECT_GT(centers[0].z(), 2);
}

}  // namespace
}  // namespace umbilic
