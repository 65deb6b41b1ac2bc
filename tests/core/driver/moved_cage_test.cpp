// SPDX-License-Identifier: MIT
/// \file
/// Runs whose cage moves on the way: what is held follows it as in new runs, and they end where new runs end.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cage/generate.h"
#include "driver/begun_run.h"
#include "driver/equations.h"
#include "driver/problem_run.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "driver/surface_state.h"

namespace umbilic {
namespace moved_cage {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

RunOptions up_to_level(int first, int last, double bending = 1, double mvs_cross = 0) {
  RunOptions options;
  options.weights[kBending] = bending;
  options.weights[kMvsCross] = mvs_cross;
  options.first_level = first;
  options.last_level = last;
  options.tolerance = 1e-10;
  return options;
}

Targets moved_to(const Points& points) {
  Targets targets;
  targets.points = points;
  return targets;
}

struct Held {
  Cage cage;
  Constraints constraints;
  std::vector<int> vertices;  ///< that are moved
};

/// A torus of which a patch is free; what is moved is the half of it that is held.
Held held_torus() {
  Held held{*generate_cage("torus"), {}, {}};
  FaceSelection faces;
  for (std::size_t f = 0; f < held.cage.faces.size(); ++f) {
    double x = 0;
    for (const int v : held.cage.faces[f]) x += held.cage.vertices(v, 0) / 4;
    if (x > -0.5) faces.faces.push_back(static_cast<int>(f) + 1);
  }
  held.constraints.hold = faces;
  for (int v = 0; v < held.cage.vertices.rows(); ++v) {
    if (held.cage.vertices(v, 0) > -0.45) held.vertices.push_back(v);
  }
  return held;
}

/// A cylinder clamped at both boundaries; what is moved is the upper one.
Held clamped_cylinder() {
  CageOptions options;
  options.major_segments = 8;
  options.minor_segments = 3;
  Held held{*generate_cage("cylinder", options), {}, {}};
  const double top = held.cage.vertices.col(2).maxCoeff();
  for (int v = 0; v < held.cage.vertices.rows(); ++v) {
    if (held.cage.vertices(v, 2) > 0.6 * top) held.vertices.push_back(v);
  }
  return held;
}

Points moved(const Held& held, const Vector3& by) {
  Points points = held.cage.vertices;
  for (const int v : held.vertices) points.row(v) += by.transpose();
  return points;
}

Cage with(Cage cage, const Points& points) {
  cage.vertices = points;
  return cage;
}

/// By how much the surface of an ended run is not where the moved cage holds it: the largest distance of held control
/// points, 0 to the last bit, or what is left of the boundary's equations.
double off(const Held& held, const Points& points, const umbilic::Run& run) {
  const RefinedCage cage = *prepare(with(held.cage, points), 0, true, held.constraints);
  const RefinedCage own = refine(cage, run.result().level);
  if (own.held.empty()) {
    const RefinedCage there = *at_state(cage, run.state(), CapKind::kSmooth, true);
    const LinearRows rows = equations_of(own).rows;
    const Eigen::Map<const Eigen::VectorXd> control(there.control.data(), there.control.size());
    return (rows.matrix * control - rows.right).cwiseAbs().maxCoeff();
  }
  const std::vector<bool> is_held = held_points(own, CapKind::kSmooth).held;
  const Points there = run.control_mesh().vertices, expected = cage.placement.back(own.own);
  double largest = 0;
  for (int v = 0; v < there.rows(); ++v) {
    if (is_held[v]) largest = std::max(largest, (there.row(v) - expected.row(v)).norm());
  }
  return largest;
}

class MovedCage : public testing::TestWithParam<bool> {
 protected:
  Held held() const { return GetParam() ? held_torus() : clamped_cylinder(); }
};
INSTANTIATE_TEST_SUITE_P(HeldAndClamped, MovedCage, testing::Bool());

TEST_P(MovedCage, leads_to_the_minimum_of_a_new_run) {
  const Held held = this->held();
  const Points points = moved(held, {0.03, 0.02, 0.1});
  umbilic::Run expected = begun(with(held.cage, points), up_to_level(1, 1), held.constraints);
  const double energy = ended(expected);
  for (const int units : {0, 12, 100000}) {
    umbilic::Run run = begun(held.cage, up_to_level(1, 1), held.constraints);
    run.step(units);
    ASSERT_FALSE(run.retarget(moved_to(points)));
    EXPECT_NEAR(ended(run), energy, 1e-8 * energy) << units;
    EXPECT_LE(off(held, points, run), GetParam() ? 0 : 1e-12);
    EXPECT_EQ(run.group().name, expected.group().name);
    EXPECT_EQ(run.cage().vertices, points);
  }
}

/// Of these functionals there are several minima, of which a new run from the cage may find another.
TEST_P(MovedCage, minimizes_what_a_new_run_does_on_all_levels_that_are_left) {
  const Held held = this->held();
  const Points points = moved(held, {0.03, 0.02, 0.1});
  RunOptions options = up_to_level(0, 2, 1, 0.1);
  options.tolerance = 1e-6;
  umbilic::Run run = begun(held.cage, options, held.constraints);
  while (run.progress().level < 1) run.step(1);
  ASSERT_FALSE(run.retarget(moved_to(points)));
  const double energy = ended(run);
  EXPECT_EQ(run.levels().front().level, 1);
  EXPECT_EQ(run.result().level, 2);
  EXPECT_LE(off(held, points, run), GetParam() ? 0 : 1e-12);
  umbilic::Run again = *umbilic::Run::create(with(held.cage, points), options, held.constraints, run.state());
  EXPECT_EQ(again.group().name, run.group().name);
  while (again.progress().evaluations < 1) again.step(1);
  EXPECT_NEAR(again.progress().energy, energy, 1e-12 * energy);
}

TEST_P(MovedCage, that_is_translated_has_the_translated_surface_at_once) {
  const Held held = this->held();
  umbilic::Run run = begun(held.cage, up_to_level(1, 1), held.constraints);
  const double energy = ended(run);
  const Points before = run.control_mesh().vertices;
  const Eigen::RowVector3d by(0.25, -0.5, 0.125);
  ASSERT_FALSE(run.retarget(moved_to(held.cage.vertices.rowwise() + by)));
  EXPECT_LT((run.control_mesh().vertices - (before.rowwise() + by)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(ended(run), energy, 1e-10 * energy);
}

/// What the energy of the moved surface is above the minimum falls with the square of the move, and so would that of an
/// answer which is wrong at first order. One that is right at first order leaves the fourth power, and what Newton's
/// metric has beside the Hessian.
TEST_P(MovedCage, is_answered_by_the_first_step_to_second_order) {
  const Held held = this->held();
  RunOptions options = up_to_level(1, 1);
  options.metric = MetricChoice::kNewton;
  double excess[2], moved_excess[2];
  for (const int i : {0, 1}) {
    umbilic::Run run = begun(held.cage, options, held.constraints);
    ended(run);
    const double by = i == 0 ? 0.06 : 0.03;
    ASSERT_FALSE(run.retarget(moved_to(moved(held, {0.5 * by, 0.3 * by, by}))));
    while (run.progress().evaluations < 1) run.step(1);
    const double first = run.progress().energy;
    while (run.progress().evaluations < 2) run.step(1);
    const double answer = run.progress().energy, energy = ended(run);
    moved_excess[i] = first - energy;
    excess[i] = answer - energy;
  }
  EXPECT_LT(excess[0], 0.05 * moved_excess[0]);
  EXPECT_NEAR(std::log2(moved_excess[0] / moved_excess[1]), 2, 0.5);
  EXPECT_GT(std::log2(excess[0] / excess[1]), 2.5);
}

TEST_P(MovedCage, that_a_hand_does_not_stop_moving_loses_nothing) {
  const Held held = this->held();
  umbilic::Run run = begun(held.cage, up_to_level(1, 1), held.constraints);
  Points points;
  for (int i = 1; i <= 30; ++i) {
    run.step(3);
    points = moved(held, {0, 0.002 * i, 0.005 * i});
    ASSERT_FALSE(run.retarget(moved_to(points)));
  }
  umbilic::Run expected = begun(with(held.cage, points), up_to_level(1, 1), held.constraints);
  const double energy = ended(expected);
  EXPECT_NEAR(ended(run), energy, 1e-6 * energy);
}

/// The errors of targets, after which the run is what it was.
std::string refusal(umbilic::Run& run, const Points& points) {
  const Points before = run.control_mesh().vertices, own = run.cage().vertices;
  const std::size_t levels = run.levels().size();
  const auto error = run.retarget(moved_to(points));
  EXPECT_EQ(run.control_mesh().vertices, before);
  EXPECT_EQ(run.cage().vertices, own);
  EXPECT_EQ(run.levels().size(), levels);
  return error ? error->message : "accepted";
}

TEST(MovedCageErrors, leave_the_run_as_it_is) {
  Held held = held_torus();
  umbilic::Run run = begun(held.cage, up_to_level(0, 0), held.constraints);
  ended(run);
  const Points points = held.cage.vertices;
  const int count = static_cast<int>(points.rows());
  EXPECT_EQ(refusal(run, points.topRows(count - 1)),
            "points: " + std::to_string(count - 1) + " for the cage's " + std::to_string(count));
  Points wrong = points;
  wrong(6, 1) = kNan;
  EXPECT_EQ(refusal(run, wrong), "points: vertex 7 is not finite");
  EXPECT_EQ(refusal(run, Points::Zero(count, 3)),
            "points: face 1 is part of no surface: all vertices of the cage coincide");
  wrong = points;
  wrong.col(2) *= -1;
  EXPECT_EQ(refusal(run, wrong), "points: the cage would be inside out; that takes a new run");
}

TEST(MovedCageErrors, name_what_contradicts_what_is_held) {
  Held held = held_torus();
  Pin pin;
  pin.vertex = 1;  // among the held faces, where the surface is
  const RefinedCage cage = *prepare(held.cage, 0, false);
  const Vector3 here = limit_stencils(cage.mesh, {SurfacePlace{.vertex = 0}})[0].apply(cage.control).col(0);
  pin.at = Coordinates3{here.x(), here.y(), here.z()};
  held.constraints.pins = {pin};
  umbilic::Run run = begun(held.cage, up_to_level(0, 0), held.constraints);
  ended(run);
  EXPECT_EQ(refusal(run, moved(held, {0, 0, 0.1})).substr(0, 12), "constraints:");
}

TEST(MovedCages, keep_the_symmetry_that_they_have) {
  const Held held = held_torus();
  umbilic::Run run = begun(held.cage, up_to_level(1, 1), held.constraints);
  ended(run);
  const std::string before = run.group().name;
  ASSERT_GT(run.group().order, 2);
  const Points along = moved(held, {0.05, 0, 0}), across = moved(held, {0.05, 0, 0.05});
  ASSERT_FALSE(run.retarget(moved_to(along)));
  EXPECT_EQ(run.group().name, before);
  ended(run);
  ASSERT_FALSE(run.retarget(moved_to(across)));
  umbilic::Run expected = begun(with(held.cage, across), up_to_level(1, 1), held.constraints);
  EXPECT_EQ(run.group().name, expected.group().name);
  const double energy = ended(expected);
  EXPECT_NEAR(ended(run), energy, 1e-8 * energy);
}

/// A run that has lost a symmetry does not find it again, but what it saves fits the cage, which has it.
TEST(MovedCages, that_become_symmetric_again_can_be_gone_on_with) {
  const Held held = held_torus();
  umbilic::Run run = begun(held.cage, up_to_level(1, 1), held.constraints);
  const int order = run.group().order;
  ASSERT_FALSE(run.retarget(moved_to(moved(held, {0.05, 0, 0.05}))));
  ASSERT_FALSE(run.retarget(moved_to(held.cage.vertices)));
  EXPECT_LT(run.group().order, order);
  const double energy = ended(run);
  auto again = umbilic::Run::create(held.cage, up_to_level(1, 1), held.constraints, run.state());
  ASSERT_TRUE(again) << again.error().message;
  while (again->progress().evaluations < 1) again->step(1);
  EXPECT_NEAR(again->progress().energy, energy, 1e-12 * energy);
}

TEST(MovedCages, pull_what_is_near_them) {
  const Cage cage = *generate_cage("two-3");
  Constraints constraints;
  constraints.closeness = Closeness{100, {}};
  const Points points = cage.vertices * Vector3(1, 1, 1.1).asDiagonal();
  umbilic::Run run = begun(cage, up_to_level(1, 1), constraints),
               expected = begun(with(cage, points), up_to_level(1, 1), constraints);
  ended(run);
  ASSERT_FALSE(run.retarget(moved_to(points)));
  const double energy = ended(expected);
  EXPECT_NEAR(ended(run), energy, 1e-7 * energy);
}

TEST(MovedCages, carry_pins_that_hold_the_surface_where_the_cage_has_it) {
  const Cage cage = *generate_cage("torus");
  Constraints constraints;
  for (const int vertex : {1, 9, 20}) constraints.pins.emplace_back().vertex = vertex;
  Points points = cage.vertices;
  points.row(0) += Eigen::RowVector3d(0, 0, 0.2);
  RunOptions options = up_to_level(0, 0);
  options.tolerance = 1e-8;
  umbilic::Run run = begun(cage, options, constraints), expected = begun(with(cage, points), options, constraints);
  ended(run);
  ASSERT_FALSE(run.retarget(moved_to(points)));
  const double energy = ended(expected);
  EXPECT_NEAR(ended(run), energy, 1e-5 * energy);
  const ConstraintsReport here = *run.constraints(), there = *expected.constraints();
  for (int i = 0; i < 3; ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(here.pins[i].position[c], there.pins[i].position[c], 1e-9);
  }
}

TEST(MovedCages, that_hold_nothing_leave_the_surface) {
  const Cage cage = *generate_cage("two-3");
  umbilic::Run run = begun(cage, up_to_level(1, 1));
  const double energy = ended(run);
  const Points before = run.control_mesh().vertices;
  ASSERT_FALSE(run.retarget(moved_to(cage.vertices * 1.5)));
  EXPECT_EQ(run.control_mesh().vertices, before);
  EXPECT_NEAR(ended(run), energy, 1e-10 * energy);
}

/// The fill's points follow the boundary, as in a new run.
TEST(MovedCages, of_a_problem_are_filled_anew) {
  Problem problem;
  problem.cage = GeneratedCage{"cylinder", {}};
  problem.options = up_to_level(1, 1);
  problem.constraints.hold.emplace();
  problem.fill.emplace();
  Problem other = problem;
  ProblemRun run = *begin_run(problem);
  Points points = generate_cage("cylinder")->vertices;
  points.row(0) += Eigen::RowVector3d(0.1, 0, 0);
  ASSERT_FALSE(run.retarget(moved_to(points)));
  const ProblemRun fresh = *begin_run(run.problem);
  EXPECT_EQ(run.run.cage().vertices, fresh.run.cage().vertices);
  EXPECT_NE(run.run.cage().vertices, begin_run(other)->run.cage().vertices);
}

}  // namespace
}  // namespace moved_cage
}  // namespace umbilic
