// SPDX-License-Identifier: MIT
/// \file
/// Runs with held points and normals, and what holding costs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "driver/equations.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "mesh/subdivision.h"

namespace umbilic {
namespace {

umbilic::Run pinned(const Cage& cage, RunOptions options, const Constraints& constraints) {
  umbilic::Run run = *umbilic::Run::create(cage, options, constraints);
  while (!run.step(1000)) {
  }
  return run;
}

RunOptions options_for(const char* functional, int last_level, double tolerance = 1e-6) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = last_level;
  options.tolerance = tolerance;
  return options;
}

Pin pin_at(int vertex, double x, double y, double z) {
  Pin pin;
  pin.vertex = vertex;
  pin.at = Coordinates3{x, y, z};
  return pin;
}

/// The torus with six of its vertices' limit points held, one of them moved: a minimum that pulls at its pins.
Constraints six_pins(const Cage& torus, double moved) {
  Constraints constraints;
  RefinedCage cage = *prepare(torus, 0, false);
  std::vector<SurfacePlace> places;
  for (const int v : {0, 9, 18, 28, 37, 45}) places.push_back({.vertex = v});
  const std::vector<LimitStencil> stencils = limit_stencils(cage.mesh, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    Vector3 at = cage.placement.back(Vector3(stencils[i].apply(cage.control).col(0)));
    if (i == 0) at[2] += moved;
    constraints.pins.push_back(pin_at(places[i].vertex + 1, at[0], at[1], at[2]));
  }
  return constraints;
}

TEST(Pins, are_held_to_1e_10_of_the_size_and_normals_to_1e_8_on_every_level) {
  const Cage torus = *generate_cage("torus");
  Constraints constraints = six_pins(torus, 0.1);
  constraints.pins[2].normal = true;
  const std::vector<HeldPoint> held = prepare(torus, 0, false, constraints)->pins;
  for (const int level : {0, 1}) {
    RunOptions options = options_for("bending", level);
    options.first_level = level;
    const umbilic::Run run = pinned(torus, options, constraints);
    RefinedCage cage = refine(*prepare(torus, 0, false, constraints), level);
    std::vector<SurfacePlace> places;
    for (const HeldPoint& pin : cage.pins) places.push_back(pin.place);
    const std::vector<LimitStencil> stencils = limit_stencils(cage.mesh, places);
    const Points control = cage.placement.to_unit(run.control_mesh().vertices);
    for (std::size_t i = 0; i < held.size(); ++i) {
      const Eigen::Matrix3d here = stencils[i].apply(control);
      EXPECT_LT((here.col(0) - held[i].position).norm(), 1e-10);
      if (i != 2) continue;
      const Vector3 normal = here.col(1).cross(here.col(2)).normalized();
      EXPECT_LT((normal - held[i].normal).norm(), 1e-8);
    }
    EXPECT_GT(run.constraints()->deviation, 0.05);
  }
}

/// dE/d(position) of the minimal energy, by central differences of two further minima. What pulls the surface to the
/// cage's own is part of that energy.
TEST(Pins, pull_with_the_derivative_of_the_minimal_energy_by_their_position) {
  Cage torus = *generate_cage("torus");
  torus.vertices *= 4;  // lengths of the cage are not those of its unit coordinates
  RunOptions options = options_for("bending", 0, 1e-12);
  options.max_iterations = 3000;
  for (const double weight : {0., 0.05}) {
    const auto run_with = [&](double moved) {
      Constraints constraints = six_pins(torus, moved);
      if (weight > 0) constraints.closeness = Closeness{weight, {}};
      return pinned(torus, options, constraints);
    };
    const PinReport pin = run_with(0.4).constraints()->pins[0];
    const double step = 0.02;
    const auto energy = [&](double moved) { return run_with(moved).result().energy; };
    const double slope = (energy(0.4 + step) - energy(0.4 - step)) / (2 * step);
    EXPECT_GT(std::abs(slope), 0.01);
    EXPECT_NEAR(pin.pull[2], slope, 1e-4 * pin.strength + 1e-3 * std::abs(slope)) << weight;
  }
}

TEST(Pins, pull_in_balance) {
  const Cage torus = *generate_cage("torus");
  const umbilic::Run run = pinned(torus, options_for("bending", 0, 1e-12), six_pins(torus, 0.1));
  Vector3 sum = Vector3::Zero();
  double largest = 0;
  const ConstraintsReport report = *run.constraints();
  for (const PinReport& pin : report.pins) {
    sum += Vector3(pin.pull[0], pin.pull[1], pin.pull[2]);
    largest = std::max(largest, pin.strength);
  }
  EXPECT_LT(sum.norm(), 1e-4 * largest);
}

/// Opposite faces' midpoints, pulled apart along an axis: D4h is the largest subgroup of the cube's Oh that keeps it.
TEST(Pins, that_are_pulled_apart_keep_the_symmetry_that_keeps_them) {
  const Cage cube = *generate_cage("cube");
  Constraints constraints;
  for (const int face : {1, 2}) {
    Pin pin;
    pin.face = face;
    pin.uv = {0.5, 0.5};
    constraints.pins.push_back(pin);
  }
  const std::vector<HeldPoint> held = prepare(cube, 0, false, constraints)->pins;
  ASSERT_LT((held[0].position + held[1].position).norm(), 1e-12) << "the first two faces are opposite ones";
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3 at = 1.5 * held[i].position;
    constraints.pins[i].at = Coordinates3{at[0], at[1], at[2]};
  }
  const umbilic::Run run = pinned(cube, options_for("mvs_cross", 1), constraints);
  EXPECT_EQ(run.group().name, "D4h");
  const ConstraintsReport report = *run.constraints();
  EXPECT_NEAR(report.pins[0].strength, report.pins[1].strength, 1e-9 * report.pins[0].strength);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(report.pins[0].pull[c], -report.pins[1].pull[c], 1e-9 * report.pins[0].strength);
  }
}

TEST(Pins, that_contradict_one_another_are_named_and_those_that_follow_are_dropped) {
  const Cage cube = *generate_cage("cube");
  Constraints constraints;
  constraints.pins = {pin_at(1, -1, -1, -1), pin_at(7, 1, 1, 1), pin_at(1, -1, -1, -0.5)};
  EXPECT_EQ(umbilic::Run::create(cube, options_for("bending", 1), constraints).error().message,
            "constraints: pin 1 (z), pin 3 (z) cannot all hold");
  constraints.pins.back() = constraints.pins.front();
  const umbilic::Run run = *umbilic::Run::create(cube, options_for("bending", 1), constraints);
  ASSERT_EQ(run.constraints()->notes.size(), 3u);
  EXPECT_EQ(run.constraints()->notes[0], "pin 3 (x) follows from the others and was dropped");
}

/// A pin whose point depends on held control points as well: moving all that is held changes nothing.
TEST(Pins, and_held_faces_beside_them_pull_in_balance) {
  const RefinedCage fine = refine(*prepare(*generate_cage("cube"), 3, false), 3);
  const Cage cage = to_cage(fine.mesh, fine.control);
  Constraints constraints;
  constraints.hold = FaceSelection{{}, {}};
  for (int f = 1; f <= 192; ++f) constraints.hold->faces.push_back(f);
  const RefinedCage prepared = *prepare(cage, 0, false, constraints);
  const std::vector<bool> held = held_points(prepared, CapKind::kSmooth).held;
  for (int f = 193; f <= 384 && constraints.pins.empty(); ++f) {
    const int h = prepared.mesh.halfedge(f - 1, 0);
    const LimitStencil stencil = limit_stencils(prepared.mesh, {{.halfedge = h, .u = 0.5, .v = 0.5}}).front();
    const auto known = std::count_if(stencil.points.begin(), stencil.points.end(), [&](int v) { return held[v]; });
    if (known < 2 || known + 2 > static_cast<std::ptrdiff_t>(stencil.points.size())) continue;
    const Vector3 here = stencil.apply(prepared.control).col(0), at = prepared.placement.back(Vector3(1.1 * here));
    Pin pin;
    pin.face = f;
    pin.uv = {0.5, 0.5};
    pin.at = Coordinates3{at[0], at[1], at[2]};
    constraints.pins = {pin};
  }
  RunOptions options = options_for("bending", 0, 1e-12);
  options.max_iterations = 3000;
  const ConstraintsReport report = *pinned(cage, options, constraints).constraints();
  Vector3 sum = Eigen::Map<const Vector3>(report.pins.at(0).pull.data());
  for (const HeldRegionReport& region : report.regions) sum += Eigen::Map<const Vector3>(region.pull.data());
  EXPECT_GT(report.pins[0].strength, 1);
  EXPECT_LT(sum.norm(), 1e-4 * report.pins[0].strength);
}

TEST(Pins, of_held_faces_contradict_them_unless_they_stay) {
  const Cage cage = to_cage(refine(*prepare(*generate_cage("cube"), 2, false), 2).mesh,
                            refine(*prepare(*generate_cage("cube"), 2, false), 2).control);
  Constraints constraints;
  constraints.hold = FaceSelection{{}, {}};
  for (int f = 1; f <= 48; ++f) constraints.hold->faces.push_back(f);
  Pin pin;
  pin.face = 1;
  pin.uv = {0.5, 0.5};
  constraints.pins = {pin};
  EXPECT_TRUE(umbilic::Run::create(cage, options_for("bending", 0), constraints));
  constraints.pins[0].at = Coordinates3{5, 5, 5};
  const std::string words = umbilic::Run::create(cage, options_for("bending", 0), constraints).error().message;
  EXPECT_NE(words.find("while the held faces stay"), std::string::npos) << words;
}

/// A start far from the pins is moved as a whole, not spiked.
TEST(Pins, far_from_the_start_move_it_smoothly) {
  const Cage cube = *generate_cage("cube");
  Constraints constraints;
  constraints.pins = {pin_at(1, 9, 9, 9)};
  const umbilic::Run run = pinned(cube, options_for("bending", 1, 1e-9), constraints);
  EXPECT_NEAR(run.result().energy, 8 * std::numbers::pi, 1e-2 * 8 * std::numbers::pi);
  EXPECT_LT(run.constraints()->pins[0].strength, 1e-4);
}

TEST(Pins, leave_the_gauge_that_keeps_them) {
  const Cage cube = *generate_cage("cube");
  const auto dimension = [&](std::vector<Pin> pins, const char* functional) {
    Constraints constraints;
    constraints.pins = std::move(pins);
    const RefinedCage cage = refine(*prepare(cube, 1, false, constraints), 1);
    return free_gauge(cage, gauge_of(*weights_of(functional))).cols();
  };
  EXPECT_EQ(dimension({}, "mvs_cross"), 7);
  EXPECT_EQ(dimension({pin_at(1, -1, -1, -1)}, "mvs_cross"), 4);
  EXPECT_EQ(dimension({pin_at(1, -1, -1, -1), pin_at(7, 1, 1, 1)}, "mvs_cross"), 1);  // rotation about the axis
  EXPECT_EQ(dimension({pin_at(1, -1, -1, -1), pin_at(7, 1, 1, 1), pin_at(2, 1, -1, -1)}, "mvs_cross"), 0);
  EXPECT_EQ(dimension({}, "bending"), 10);
}

TEST(Pins, leave_the_size_open_unless_there_are_two) {
  const Cage cube = *generate_cage("cube");
  Constraints one, two;
  one.pins = {pin_at(1, -1, -1, -1)};
  two.pins = {pin_at(1, -1, -1, -1), pin_at(7, 1, 1, 1)};
  EXPECT_TRUE(leaves_size_open(*prepare(cube, 0, false, one)));
  EXPECT_FALSE(leaves_size_open(*prepare(cube, 0, false, two)));
}

}  // namespace
}  // namespace umbilic
