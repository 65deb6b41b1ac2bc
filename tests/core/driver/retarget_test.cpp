// SPDX-License-Identifier: MIT
/// \file
/// Runs whose weights, pins and pull change on the way end where new runs end.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cage/generate.h"
#include "driver/begun_run.h"
#include "driver/pin_rows.h"
#include "driver/run.h"
#include "driver/surface.h"

namespace umbilic {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

RunOptions up_to_level(int level, double bending, double mvs_cross = 0) {
  RunOptions options;
  options.weights[kBending] = bending;
  options.weights[kMvsCross] = mvs_cross;
  options.first_level = level;
  options.last_level = level;
  options.tolerance = 1e-9;
  return options;
}

/// The first point of the torus and a place opposite are held, the first `up` above where the surface has it.
Constraints two_pins(const Cage& torus, double up) {
  const RefinedCage cage = *prepare(torus, 0, false);
  Constraints constraints;
  for (const int v : {0, 24}) {
    const LimitStencil here = limit_stencils(cage.mesh, {SurfacePlace{.vertex = v}})[0];
    const Vector3 at = cage.placement.back(Vector3(here.apply(cage.control).col(0)));
    Pin pin;
    pin.vertex = v + 1;
    pin.at = Coordinates3{at.x(), at.y(), at.z() + (v == 0 ? up : 0)};
    constraints.pins.push_back(pin);
  }
  return constraints;
}

/// Targets where other pins of the same kind lie.
Targets targets_of(const Constraints& constraints) {
  Targets targets;
  for (const Pin& pin : constraints.pins) {
    PinTarget& target = targets.pins.emplace_back(PinTarget{pin.at, {}});
    if (pin.holds_normal()) target.normal = std::get<Coordinates3>(*pin.normal);
  }
  return targets;
}

/// The surface's point and tangents where the first pin is, in the cage's own coordinates.
Eigen::Matrix3d at_first_pin(const Cage& torus, const Constraints& constraints, const umbilic::Run& run) {
  const RefinedCage cage = *prepare(torus, 0, false, constraints);
  return limit_stencils(cage.mesh, {cage.pins[0].place})[0].apply(run.control_mesh().vertices);
}

std::string refusal(umbilic::Run& run, const Targets& targets) {
  const Points before = run.control_mesh().vertices;
  const int levels = static_cast<int>(run.levels().size());
  const auto error = run.retarget(targets);
  EXPECT_EQ(run.control_mesh().vertices, before);
  EXPECT_EQ(run.levels().size(), levels);
  return error ? error->message : "accepted";
}

TEST(Retarget, other_weights_lead_to_the_minimum_of_a_new_run) {
  const Cage cage = *generate_cage("two-3");
  umbilic::Run expected = begun(cage, up_to_level(1, 0.5, 0.5));
  const double energy = ended(expected);
  for (const bool in_the_middle : {true, false}) {
    umbilic::Run run = begun(cage, up_to_level(1, 1));
    run.step(in_the_middle ? 12 : 1000);
    Targets targets;
    targets.terms.emplace();
    (*targets.terms)[kBending] = (*targets.terms)[kMvsCross] = 0.5;
    ASSERT_FALSE(run.retarget(targets));
    EXPECT_TRUE(run.levels().empty());
    EXPECT_NEAR(ended(run), energy, 1e-6 * energy);
    EXPECT_EQ(run.levels().size(), 1);
  }
}

TEST(Retarget, a_run_of_several_levels_goes_on_through_those_that_are_left) {
  RunOptions options = up_to_level(0, 1);
  options.last_level = 2;
  umbilic::Run run = begun(*generate_cage("two-3"), options);
  while (run.progress().level < 1) run.step(1);
  Targets targets;
  targets.terms = options.weights;
  ASSERT_FALSE(run.retarget(targets));
  ended(run);
  ASSERT_EQ(run.levels().size(), 2);
  EXPECT_EQ(run.levels().front().level, 1);
  EXPECT_EQ(run.result().level, 2);
}

TEST(Retarget, moved_pins_are_held_and_lead_to_the_minimum_of_a_new_run) {
  const Cage torus = *generate_cage("torus");
  const Constraints moved = two_pins(torus, 0.15);
  umbilic::Run expected = begun(torus, up_to_level(0, 1), moved);
  const double energy = ended(expected);
  for (const int units : {0, 1, 9, 1000}) {
    umbilic::Run run = begun(torus, up_to_level(0, 1), two_pins(torus, 0.05));
    run.step(units);
    ASSERT_FALSE(run.retarget(targets_of(moved)));
    EXPECT_NEAR(ended(run), energy, 1e-5 * energy) << units;
    const Vector3 at = Eigen::Map<const Vector3>(moved.pins[0].at->data());
    EXPECT_LT((at_first_pin(torus, moved, run).col(0) - at).norm(), 1e-10);
  }
}

/// There are several minima, of which a new run may find another.
TEST(Retarget, a_turned_normal_leads_to_a_minimum_of_the_new_problem) {
  const Cage torus = *generate_cage("torus");
  Constraints before = two_pins(torus, 0.05), after = before;
  before.pins[0].normal = Coordinates3{1, 0, 0};
  after.pins[0].normal = Coordinates3{1, 0, 0.2};
  umbilic::Run run = begun(torus, up_to_level(0, 1), before);
  const double energy_before = ended(run);
  ASSERT_FALSE(run.retarget(targets_of(after)));
  const double energy = ended(run);
  EXPECT_NE(energy, energy_before);
  umbilic::Run again = *umbilic::Run::create(torus, up_to_level(0, 1), after, run.state());
  EXPECT_NEAR(ended(again), energy, 1e-8 * energy);
  const Eigen::Matrix3d here = at_first_pin(torus, after, run);
  EXPECT_LT((here.col(1).cross(here.col(2)).normalized() - Vector3(1, 0, 0.2).normalized()).norm(), 1e-8);
}

TEST(Retarget, another_pull_leads_to_the_minimum_of_a_new_run) {
  const Cage cage = *generate_cage("two-3");
  Constraints weak, strong;
  weak.closeness = Closeness{10, {}};
  strong.closeness = Closeness{1000, {}};
  umbilic::Run expected = begun(cage, up_to_level(0, 1), strong), run = begun(cage, up_to_level(0, 1), weak);
  const double energy = ended(expected);
  ended(run);
  Targets targets;
  targets.closeness = 1000;
  ASSERT_FALSE(run.retarget(targets));
  EXPECT_NEAR(ended(run), energy, 1e-7 * energy);
}

/// Newton's metric costs as much as many evaluations; the first answer does not wait for a new one.
TEST(Retarget, the_first_steps_answer_with_the_metric_that_is_there) {
  const Cage torus = *generate_cage("torus");
  RunOptions options = up_to_level(0, 1, 0.1);
  options.metric = MetricChoice::kNewton;
  umbilic::Run run = begun(torus, options, two_pins(torus, 0.1));
  ended(run);
  ASSERT_FALSE(run.retarget(targets_of(two_pins(torus, 0.101))));
  int units = 0;
  double moved = kNan;
  for (; run.progress().evaluations < 2; ++units) {
    run.step(1);
    if (run.progress().evaluations == 1) moved = run.progress().energy;
  }
  const double answer = run.progress().energy;
  EXPECT_LE(units, 4);
  const double energy = ended(run);
  EXPECT_LT(answer - energy, 0.05 * (moved - energy));
}

TEST(Retarget, a_hand_that_does_not_stop_loses_nothing) {
  const Cage torus = *generate_cage("torus");
  umbilic::Run run = begun(torus, up_to_level(0, 1, 0.1), two_pins(torus, 0.05));
  for (int i = 0; i < 40; ++i) {
    run.step(3);
    ASSERT_FALSE(run.retarget(targets_of(two_pins(torus, 0.05 + 0.0025 * i))));
  }
  umbilic::Run expected = begun(torus, up_to_level(0, 1, 0.1), two_pins(torus, 0.05 + 0.0025 * 39));
  const double energy = ended(expected);
  EXPECT_NEAR(ended(run), energy, 1e-3 * energy);
}

TEST(Retarget, what_does_not_fit_is_refused_and_changes_nothing) {
  const Cage torus = *generate_cage("torus");
  Constraints constraints = two_pins(torus, 0.05);
  (*constraints.pins[1].at)[1] = kNan;
  umbilic::Run run = begun(torus, up_to_level(0, 1), constraints);
  run.step(10);
  Targets targets;
  targets.terms.emplace();
  EXPECT_EQ(refusal(run, targets).substr(0, 7), "terms: ");
  targets = {};
  targets.pins.resize(1);
  EXPECT_EQ(refusal(run, targets), "pins: 1 for the problem's 2");
  targets.pins.resize(2);
  targets.pins[0].at = {0, kNan, 0};
  EXPECT_EQ(refusal(run, targets), "pins[0].at[1]: null, but the pin holds this coordinate");
  targets.pins[0].at.reset();
  targets.pins[1].at = {0, 1, 0};
  EXPECT_EQ(refusal(run, targets), "pins[1].at[1]: the pin leaves this coordinate free: expected null");
  targets.pins[1].at.reset();
  targets.pins[1].normal = {0, 0, 1};
  EXPECT_EQ(refusal(run, targets), "pins[1].normal: the pin holds only the position");
  targets = {};
  targets.closeness = 3;
  EXPECT_EQ(refusal(run, targets), "closeness: the problem has no constraints.closeness.weight");
}

TEST(Retarget, of_the_symmetry_is_left_what_the_targets_have) {
  const Cage torus = *generate_cage("torus");
  const Constraints moved = two_pins(torus, 0.1);
  umbilic::Run expected = begun(torus, up_to_level(0, 1), moved),
               run = begun(torus, up_to_level(0, 1), two_pins(torus, 0));
  ended(run);
  ASSERT_GT(run.group().order, expected.group().order);
  ASSERT_FALSE(run.retarget(targets_of(moved)));
  EXPECT_EQ(run.group().name, expected.group().name);
  EXPECT_NEAR(ended(run), ended(expected), 1e-4 * ended(expected));
  umbilic::Run again = *umbilic::Run::create(torus, up_to_level(0, 1), moved, run.state());
  EXPECT_NEAR(ended(again), ended(run), 1e-8 * ended(run));
}

TEST(Retarget, copies_of_pins_move_with_them) {
  const Cage frame = *generate_cage("two-3");
  const Vector3 first = frame.vertices.row(0);
  const auto out = [&](double factor) {
    Constraints constraints;
    Pin pin;
    pin.vertex = 1;
    pin.at = Coordinates3{factor * first[0], factor * first[1], factor * first[2]};
    constraints.pins = {pin};
    constraints.symmetric = true;
    return constraints;
  };
  umbilic::Run run = begun(frame, up_to_level(1, 1), out(1)), expected = begun(frame, up_to_level(1, 1), out(1.1));
  ended(run);
  ASSERT_FALSE(run.retarget(targets_of(out(1.1))));
  EXPECT_NEAR(ended(run), ended(expected), 1e-6 * ended(expected));
  EXPECT_EQ(run.group().name, "D3h");
  EXPECT_EQ(run.constraints()->pins.size(), expected.constraints()->pins.size());
}

}  // namespace
}  // namespace umbilic
