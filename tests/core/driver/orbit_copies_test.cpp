// SPDX-License-Identifier: MIT
/// \file
/// Pins and held faces that are copied to all places to which the cage's symmetry maps them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "cage/generate.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "mesh/subgroup.h"

namespace umbilic {
namespace {

Constraints symmetric(Constraints constraints) {
  constraints.symmetric = true;
  return constraints;
}

Constraints holding_faces(std::vector<int> faces) {
  Constraints constraints;
  constraints.hold = FaceSelection{{}, std::move(faces)};
  return constraints;
}

Constraints pinned_at(int vertex, std::optional<Coordinates3> at = {}, bool normal = false) {
  Constraints constraints;
  Pin pin;
  pin.vertex = vertex;
  pin.at = at;
  if (normal) pin.normal = true;
  constraints.pins = {pin};
  return constraints;
}

RunOptions levels_up_to(const char* functional, int last_level) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = last_level;
  return options;
}

/// A cage of 96 quads with Oh.
Cage fine_cube() {
  const RefinedCage fine = refine(*prepare(*generate_cage("cube"), 2, true), 2);
  return to_cage(fine.mesh, fine.control);
}

TEST(OrbitCopies, of_a_pin_keep_the_symmetry_that_it_alone_would_break) {
  const Cage cage = *generate_cage("two-3");
  const Vector3 first = cage.vertices.row(0);
  const Constraints one = pinned_at(1, Coordinates3{1.2 * first[0], 1.2 * first[1], 1.2 * first[2]}, true);
  const Result<RefinedCage> alone = prepare(cage, 1, true, one), copied = prepare(cage, 1, true, symmetric(one));
  ASSERT_TRUE(alone && copied);
  EXPECT_LT(alone->symmetry.order, 12);
  EXPECT_EQ(copied->symmetry.name, "D3h");
  // As many as the vertex has images.
  std::set<int> images;
  const PolygonMesh mesh(cage);
  for (const Symmetry& element : elements_of(copied->symmetry, mesh))
    images.insert(image_of_vertex(mesh, element.map, 0));
  EXPECT_EQ(copied->pins.size(), images.size());
  EXPECT_GT(copied->pins.size(), 1u);
  for (std::size_t i = 0; i < copied->pins.size(); ++i) {
    EXPECT_EQ(copied->pins[i].pin, 0);
    EXPECT_EQ(copied->pins[i].copy, static_cast<int>(i));
    EXPECT_TRUE(images.count(copied->pins[i].place.vertex));
    EXPECT_NEAR((copied->pins[i].position - copied->symmetry.center).norm(),
                (copied->pins[0].position - copied->symmetry.center).norm(), 1e-12);
  }
}

TEST(OrbitCopies, of_a_pin_pull_as_strongly_as_it_and_are_numbered_in_the_report) {
  Constraints constraints = symmetric(pinned_at(1, Coordinates3{-1, -1, -1}));
  Pin middle;
  middle.face = 1;
  middle.uv = {0.5, 0.5};
  constraints.pins.push_back(middle);
  umbilic::Run run = *umbilic::Run::create(*generate_cage("cube"), levels_up_to("mvs_cross", 1), constraints);
  while (!run.step(1000)) {
  }
  EXPECT_EQ(run.group().name, "Oh");
  const std::vector<PinReport> pins = run.constraints()->pins;
  ASSERT_EQ(pins.size(), 8u + 6u);
  EXPECT_EQ(pins[0].pin, 1);
  EXPECT_EQ(pins[1].pin, 2);
  EXPECT_GT(pins[0].strength, 1);
  for (std::size_t i = 2; i < pins.size(); ++i) {
    const int source = i < 2 + 7 ? 0 : 1;
    EXPECT_EQ(pins[i].pin, source + 1);
    EXPECT_EQ(pins[i].copy, static_cast<int>(i) - (source == 0 ? 1 : 8));
    EXPECT_NEAR(pins[i].strength, pins[source].strength, 1e-9 * pins[0].strength);
  }
}

/// The corner lies on mirror planes on which its target does not lie.
TEST(OrbitCopies, of_a_pin_cannot_hold_one_point_in_several_places) {
  const Constraints constraints = symmetric(pinned_at(1, Coordinates3{-0.9, -1, -1.1}));
  const Result<umbilic::Run> run =
      umbilic::Run::create(*generate_cage("cube"), levels_up_to("bending", 1), constraints);
  ASSERT_FALSE(run);
  EXPECT_NE(run.error().message.find("constraints: pin 1 ("), std::string::npos) << run.error().message;
  EXPECT_NE(run.error().message.find("cannot "), std::string::npos) << run.error().message;
}

TEST(OrbitCopies, of_single_coordinates_need_a_symmetry_that_maps_them_to_coordinates) {
  const double nan = std::nan("");
  const Cage cube = *generate_cage("cube"), frame = *generate_cage("two-3");
  EXPECT_TRUE(prepare(cube, 1, true, symmetric(pinned_at(1, Coordinates3{nan, nan, -1}))));
  EXPECT_EQ(prepare(frame, 1, true, symmetric(pinned_at(1, Coordinates3{0.5, nan, nan}))).error().message,
            "constraints.pins[0].at: only some coordinates are held, which the cage's symmetry does not map to "
            "coordinates; hold all three, or leave out constraints.symmetric");
}

TEST(OrbitCopies, of_held_faces_keep_the_symmetry) {
  const Cage cage = fine_cube();
  const Constraints one = holding_faces({1});
  const RefinedCage alone = *prepare(cage, 0, true, one), copied = *prepare(cage, 0, true, symmetric(one));
  EXPECT_EQ(std::count(alone.held.begin(), alone.held.end(), true), 1);
  EXPECT_LT(alone.symmetry.order, 48);
  EXPECT_EQ(copied.symmetry.name, "Oh");
  const Orbits orbits = face_orbits(copied.mesh, copied.symmetry);
  EXPECT_EQ(std::count(copied.held.begin(), copied.held.end(), true), orbits.sizes[orbits.of[0]]);
}

TEST(OrbitCopies, of_free_faces_are_free) {
  const Cage cage = fine_cube();
  Constraints constraints;
  constraints.free = FaceSelection{{}, {1}};
  const RefinedCage copied = *prepare(cage, 0, true, symmetric(constraints));
  const Orbits orbits = face_orbits(copied.mesh, copied.symmetry);
  EXPECT_EQ(std::count(copied.held.begin(), copied.held.end(), false), orbits.sizes[orbits.of[0]]);
  EXPECT_EQ(copied.symmetry.name, "Oh");
}

TEST(OrbitCopies, of_held_faces_on_an_open_cage_leave_its_holes_alone) {
  CageOptions options;
  options.major_segments = 8;
  options.minor_segments = 6;
  const RefinedCage copied = *prepare(*generate_cage("cylinder", options), 0, true, symmetric(holding_faces({1})));
  EXPECT_EQ(std::count(copied.held.begin(), copied.held.end(), true), 16) << "both end rings";
  EXPECT_EQ(copied.symmetry.order, 32);
}

TEST(OrbitCopies, that_leave_nothing_free_are_refused) {
  const Cage cube = *generate_cage("cube");
  EXPECT_EQ(prepare(cube, 1, true, symmetric(holding_faces({1}))).error().message,
            "constraints.symmetric: all faces are held; nothing is free");
}

/// Points with four decimals: what is held is symmetric only once the cage is.
TEST(OrbitCopies, are_made_of_a_cage_that_its_file_has_rounded) {
  Cage cage = fine_cube();
  cage.vertices = (cage.vertices * 1e4).array().round() / 1e4;
  cage.vertices(3, 0) += 4e-5;
  const Constraints one = holding_faces({1});
  EXPECT_EQ(prepare(cage, 0, true, symmetric(one))->symmetry.name, "Oh");
}

TEST(OrbitCopies, are_held_without_symmetry_of_the_surface_as_well) {
  const RefinedCage copied = *prepare(fine_cube(), 0, false, symmetric(holding_faces({1})));
  EXPECT_EQ(copied.symmetry.order, 1);
  EXPECT_GT(std::count(copied.held.begin(), copied.held.end(), true), 1);
}

/// A mirror exchanges the two boundaries of a cylinder.
TEST(OrbitCopies, of_a_boundary_keep_the_symmetry_and_must_not_meet_another_condition) {
  const Cage cylinder = *generate_cage("cylinder");
  Constraints constraints;
  constraints.boundary = BoundaryConditions{BoundaryCondition::kTangent, {{1, {}, {}, BoundaryCondition::kPosition}}};
  const auto order = [&](const Constraints& wanted) { return prepare(cylinder, 1, true, wanted)->symmetry.order; };
  const int whole = order({});
  EXPECT_EQ(order(constraints), whole / 2);
  constraints.symmetric = true;
  EXPECT_EQ(order(constraints), whole);
  const RefinedCage copied = *prepare(cylinder, 1, true, constraints);
  for (int h = 0; h < copied.mesh.surface_halfedge_count(); ++h) {
    if (!copied.mesh.is_boundary(h)) continue;
    EXPECT_EQ(copied.boundary[h], BoundaryCondition::kPosition);
  }
  constraints.boundary->loops.push_back({2, {}, {}, BoundaryCondition::kFree});
  EXPECT_EQ(
      prepare(cylinder, 1, true, constraints).error().message,
      "constraints.boundary.loops[1].condition: free, but constraints.symmetric copies loops[0] to there, which is "
      "position");
}

}  // namespace
}  // namespace umbilic
