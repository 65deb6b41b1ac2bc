// SPDX-License-Identifier: MIT
/// \file
/// Symmetry of cages whose coordinates are rounded or perturbed, of several components, and of degenerate cages.
#include <gtest/gtest.h>

#include <limits>

#include "mesh/coordinates.h"
#include "mesh/group_elements.h"
#include "mesh/symmetric_cages.h"

namespace umbilic::test {
namespace {

SymmetryGroup symmetry_of(const Cage& cage) { return find_symmetry(PolygonMesh(cage), cage.vertices); }

double extent_of(const Cage& cage) {
  return (cage.vertices.rowwise() - cage.vertices.colwise().mean()).rowwise().norm().maxCoeff();
}

/// Products of the isometries depend only on the element, and are orthogonal, to the rounding of words of a few
/// letters.
void expect_exact(const Cage& cage, const SymmetryGroup& group) {
  const PolygonMesh mesh(cage);
  const std::vector<Symmetry> elements = all_elements(group, mesh);
  ASSERT_EQ(static_cast<int>(elements.size()), group.order);
  for (const Symmetry& generator : group.generators) {
    EXPECT_LT((generator.isometry * generator.isometry.transpose() - Matrix3::Identity()).norm(), 3e-15);
    for (const Symmetry& element : elements) {
      const Symmetry both = product(generator, element);
      for (const Symmetry& known : elements) {
        if (known.map.reverses != both.map.reverses || known.map.halfedges != both.map.halfedges) continue;
        EXPECT_LT((known.isometry - both.isometry).norm(), 2e-14);
      }
    }
  }
}

TEST(SymmetryNoise, coordinates_with_4_to_7_decimals_keep_the_group_and_its_isometries_are_exact) {
  for (const PointGroup& group : point_groups()) {
    for (const double decimals : {1e4, 1e5, 1e7}) {
      SCOPED_TRACE(group.name);
      // In general position, where no coordinate is a short decimal number.
      Cage cage = transformed(cage_with(group), some_rotation(), {0.1, 0.2, 0.3});
      cage.vertices = ((cage.vertices * decimals).array().round() / decimals).matrix().eval();
      const SymmetryGroup found = symmetry_of(cage);
      EXPECT_EQ(found.name, group.name);
      EXPECT_EQ(found.order, group.order);
      if (decimals < 1e5) expect_exact(cage, found);
    }
  }
}

TEST(SymmetryNoise, perturbations_of_half_the_tolerance_keep_the_group_and_of_20_times_lose_it) {
  for (const PointGroup& group : point_groups()) {
    const Cage cage = cage_with(group);
    const double tolerance = kSymmetryTolerance * extent_of(cage);
    // Coordinates within 1 / sqrt(3) are distances within 1.
    const Points noise = Random(9).points(cage.vertices.rows()) / std::sqrt(3.);
    Cage near = cage, far = cage;
    near.vertices += 0.5 * tolerance * noise;
    far.vertices += 20 * tolerance * noise;
    EXPECT_EQ(symmetry_of(near).name, group.name);
    EXPECT_EQ(symmetry_of(far).name, "C1") << group.name;
  }
}

TEST(SymmetryNoise, whatever_the_perturbation_the_group_found_moves_no_point_by_more_than_the_tolerance) {
  for (const PointGroup& group : point_groups()) {
    for (const double amount : {0.5, 0.8, 1., 1.2, 1.5, 2., 3., 5.}) {
      Cage cage = cage_with(group);
      const double tolerance = kSymmetryTolerance * extent_of(cage);
      cage.vertices += amount * tolerance * Random(4).points(cage.vertices.rows());
      const PolygonMesh mesh(cage);
      const SymmetryGroup found = find_symmetry(mesh, cage.vertices);
      const Coordinates coordinates(mesh, found);
      const Points symmetric = coordinates.control(coordinates.unknowns(cage.vertices));
      EXPECT_LE((symmetric - cage.vertices).rowwise().norm().maxCoeff(), 1.01 * tolerance);
      EXPECT_EQ(group.order % found.order, 0) << "a subgroup";
      expect_exact(cage, found);
    }
  }
}

TEST(SymmetryNoise, a_cube_with_one_corner_moved_has_the_mirrors_and_rotations_about_its_diagonal) {
  for (const double amount : {2e-4, 4e-4, 1e-3, 0.1}) {
    Cage cage = cube();
    cage.vertices.row(6) *= 1 + amount;
    EXPECT_EQ(symmetry_of(cage).name, "C3v") << amount;
  }
  Cage cage = cube();
  cage.vertices.row(6) *= 1 + 0.5 * kSymmetryTolerance;
  EXPECT_EQ(symmetry_of(cage).name, "Oh");
}

TEST(SymmetryNoise, a_deviation_that_grows_slowly_around_a_torus_is_no_symmetry) {
  // Neighbouring segments differ by less than the tolerance, opposite ones by a hundredth.
  CageOptions options;
  options.major_segments = 1000;
  Cage cage = generate_cage("torus", options).value();
  for (Eigen::Index v = 0; v < cage.vertices.rows(); ++v) {
    cage.vertices.row(v) *= 1 + 0.005 * std::sin(std::atan2(cage.vertices(v, 1), cage.vertices(v, 0)));
  }
  const SymmetryGroup group = symmetry_of(cage);
  EXPECT_EQ(group.name, "C2v") << "the mirrors of the sine and of the torus";
}

TEST(SymmetryNoise, rounded_bodies_of_revolution_keep_their_thousand_turns) {
  CageOptions options;
  options.major_segments = 1000;
  Cage cage = generate_cage("torus", options).value();
  cage.vertices = ((cage.vertices * 1e5).array().round() / 1e5).matrix().eval();
  EXPECT_EQ(symmetry_of(cage).name, "D1000h");
}

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
  expect_exact(cage, group);
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

TEST(SymmetryDegenerate, a_box_without_height_keeps_the_group_of_the_box) {
  // Maps that reverse the orientation go with isometries that do.
  EXPECT_EQ(symmetry_of(transformed(cube(), Vector3(1, 1, 0).asDiagonal())).name, "D4h");
  EXPECT_EQ(symmetry_of(transformed(cube(), Vector3(1, 2, 0).asDiagonal())).name, "D2h");
  EXPECT_EQ(symmetry_of(transformed(cube(), some_rotation() * Vector3(1, 2, 1e-9).asDiagonal())).name, "D2h");
}

}  // namespace
}  // namespace umbilic::test
