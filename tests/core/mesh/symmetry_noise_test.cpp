// SPDX-License-Identifier: MIT
/// \file
/// Symmetry of cages whose coordinates are rounded or perturbed.
#include <gtest/gtest.h>

#include "mesh/coordinates.h"
#include "mesh/group_elements.h"
#include "mesh/symmetric_cages.h"

namespace umbilic::test {
namespace {

double extent_of(const Cage& cage) {
  return (cage.vertices.rowwise() - cage.vertices.colwise().mean()).rowwise().norm().maxCoeff();
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
      if (decimals < 1e5) expect_exact(PolygonMesh(cage), found);
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
    for (const double amount : {0.7, 1., 1.5, 3.}) {
      Cage cage = cage_with(group);
      const double tolerance = kSymmetryTolerance * extent_of(cage);
      cage.vertices += amount * tolerance * Random(4).points(cage.vertices.rows());
      const PolygonMesh mesh(cage);
      const SymmetryGroup found = find_symmetry(mesh, cage.vertices);
      const Coordinates coordinates(mesh, found);
      const Points symmetric = coordinates.control(coordinates.unknowns(cage.vertices));
      EXPECT_LE((symmetric - cage.vertices).rowwise().norm().maxCoeff(), 1.01 * tolerance);
      EXPECT_EQ(group.order % found.order, 0) << "a subgroup";
      expect_exact(PolygonMesh(cage), found);
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

}  // namespace
}  // namespace umbilic::test
