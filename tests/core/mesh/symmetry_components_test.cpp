// SPDX-License-Identifier: MIT
/// \file
/// Symmetry of cages of several components, and of cages that determine no symmetry.
#include <gtest/gtest.h>

#include <limits>

#include "mesh/group_elements.h"
#include "mesh/symmetric_cages.h"

namespace umbilic::test {
namespace {

SymmetryGroup symmetry_of(const Cage& cage) { return find_symmetry(PolygonMesh(cage), cage.vertices); }

TEST(SymmetryComponents, six_cubes_on_the_axes_have_the_symmetry_of_the_octahedron) {
  std::vector<Cage> cubes;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-4., 4.}) {
      cubes.push_back(transformed(cube(), Matrix3::Identity(), side * Vector3::Unit(axis)));
    }
  }
  const Cage cage = together(cubes);
  const PolygonMesh mesh(cage);
  const SymmetryGroup group = find_symmetry(mesh, cage.vertices);
  EXPECT_EQ(group.name, "Oh");
  for (const Symmetry& g : group.generators) {
    expect_automorphism(mesh, g.map);
    EXPECT_LT(error_of(mesh, cage.vertices, group.center, g), 1e-14 * 5);
  }
  EXPECT_EQ(face_orbits(mesh, group).sizes, (std::vector<int>{24, 6, 6})) << "side, outer and inner faces";
  cubes.pop_back();
  EXPECT_EQ(symmetry_of(together(cubes)).name, "C4v");
}

TEST(SymmetryComponents, small_cages_far_apart_keep_their_group_when_their_coordinates_are_rounded) {
  // The points of one of them determine the isometry to a tenth of a degree or so.
  std::vector<Cage> cubes;
  for (const Vector3& corner : {Vector3(1, 1, 1), Vector3(1, -1, -1), Vector3(-1, 1, -1), Vector3(-1, -1, 1)}) {
    cubes.push_back(transformed(cube(), 0.02 * Matrix3::Identity(), corner));
  }
  Cage cage = transformed(together(cubes), some_rotation());
  cage.vertices = ((cage.vertices * 1e4).array().round() / 1e4).matrix().eval();
  const SymmetryGroup group = symmetry_of(cage);
  EXPECT_EQ(group.name, "Td");
  expect_exact(PolygonMesh(cage), group);
}

TEST(SymmetryComponents, a_cube_around_a_dodecahedron_has_what_both_have) {
  const Cage inner = generate_cage("dodecahedron-frame").value();
  const Cage cage = together({inner, transformed(cube(), 3 * Matrix3::Identity())});
  EXPECT_EQ(symmetry_of(cage).name, "Th");
  EXPECT_EQ(symmetry_of(together({transformed(cube(), 3 * some_rotation()), inner})).name, "Ci");
}

TEST(SymmetryComponents, a_chiral_cage_and_its_mirror_image_change_places_by_a_mirror) {
  const Cage chiral = cage_with({"C1", 1, {}, Supergroup::kPrismatic, 2});
  const Cage right = transformed(chiral, Matrix3::Identity(), {5, 0, 0});
  EXPECT_EQ(symmetry_of(together({right, transformed(right, reflection(Vector3::UnitX()))})).name, "Cs");
  EXPECT_EQ(symmetry_of(together({right, transformed(right, rotation(0.5, Vector3::UnitY()))})).name, "C2");
  EXPECT_EQ(symmetry_of(together({right, transformed(right, -Matrix3::Identity())})).name, "Ci");
  EXPECT_EQ(symmetry_of(together({right, transformed(chiral, reflection(Vector3::UnitY()), {-5, 0, 0})})).name, "C1")
      << "a glide keeps no point";
}

TEST(SymmetryDegenerate, points_that_coincide_or_lie_on_a_line_or_are_not_finite_have_no_group) {
  Cage cage = cube();
  cage.vertices.setConstant(3);
  EXPECT_EQ(symmetry_of(cage).name, "C1");
  for (int v = 0; v < 8; ++v) cage.vertices.row(v) << v, 2 * v, -v;
  EXPECT_EQ(symmetry_of(cage).name, "C1");
  cage.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(symmetry_of(cage).name, "C1");
  EXPECT_EQ(find_symmetry(PolygonMesh(0, {}), Points(0, 3)).name, "C1");
}

TEST(SymmetryDegenerate, two_components_in_one_place_have_no_group) {
  EXPECT_EQ(symmetry_of(together({cube(), cube()})).name, "C1");
}

TEST(SymmetryDegenerateSlow, the_search_ends_among_hundreds_of_equal_components_in_one_place_and_says_that_it_gave_up) {
  const Cage cage = together(std::vector<Cage>(300, cube()));
  const PolygonMesh mesh(cage);
  const SymmetryGroup group = find_symmetry(mesh, cage.vertices);
  EXPECT_FALSE(group.complete);
  // Whatever it found is a group of symmetries: its name may be C1's or any other's that the cube has.
  EXPECT_EQ(48 % group.order, 0);
  expect_exact(mesh, group);
  for (const Symmetry& g : group.generators) {
    expect_automorphism(mesh, g.map);
    EXPECT_LT(error_of(mesh, cage.vertices, group.center, g), 1e-14);
  }
}

TEST(SymmetryDegenerate, the_search_for_the_group_of_many_components_in_their_own_places_is_complete) {
  std::vector<Cage> cubes;
  for (int i = 0; i < 60; ++i) {
    cubes.push_back(transformed(cube(), rotation(i / 60., Vector3::UnitZ()) * 0.1,
                                rotation(i / 60., Vector3::UnitZ()) * Vector3(5, 0, 0)));
  }
  const SymmetryGroup group = symmetry_of(together(cubes));
  EXPECT_TRUE(group.complete);
  EXPECT_EQ(group.name, "D60h");
}

TEST(SymmetryDegenerate, two_small_components_in_one_place_move_with_a_larger_one_that_is_alone) {
  const Cage small = transformed(tetrahedron(), 0.5 * Matrix3::Identity());
  const Cage cage = together({small, transformed(cube(), 3 * Matrix3::Identity()), small});
  const PolygonMesh mesh(cage);
  const SymmetryGroup group = find_symmetry(mesh, cage.vertices);
  EXPECT_EQ(group.name, "Td");
  EXPECT_EQ(all_elements(group, mesh).size(), 24u);
}

TEST(SymmetryDegenerate, a_box_without_height_keeps_the_group_of_the_box) {
  // Maps that reverse the orientation go with isometries that do.
  EXPECT_EQ(symmetry_of(transformed(cube(), Vector3(1, 1, 0).asDiagonal())).name, "D4h");
  EXPECT_EQ(symmetry_of(transformed(cube(), Vector3(1, 2, 0).asDiagonal())).name, "D2h");
  EXPECT_EQ(symmetry_of(transformed(cube(), some_rotation() * Vector3(1, 2, 1e-9).asDiagonal())).name, "D2h");
}

}  // namespace
}  // namespace umbilic::test
