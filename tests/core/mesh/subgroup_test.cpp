// SPDX-License-Identifier: MIT
/// \file
/// Subgroups of the elements that keep something.
#include "mesh/subgroup.h"

#include <gtest/gtest.h>

#include "cage/generate.h"

namespace umbilic {
namespace {

struct Symmetric {
  Cage cage;
  PolygonMesh mesh;
  SymmetryGroup group;

  explicit Symmetric(const char* name)
      : cage(*generate_cage(name)), mesh(cage), group(find_symmetry(mesh, cage.vertices)) {}

  /// The subgroup that maps the face to itself.
  SymmetryGroup keeping_face(int f) const {
    return subgroup(group, mesh, [&](const Symmetry& s) { return image_of_face(mesh, s.map, f) == f; });
  }
};

TEST(Subgroup, that_keeps_everything_is_the_group) {
  const Symmetric cube("cube");
  const SymmetryGroup all = subgroup(cube.group, cube.mesh, [](const Symmetry&) { return true; });
  EXPECT_EQ(all.name, "Oh");
  EXPECT_EQ(all.order, 48);
}

TEST(Subgroup, lists_the_elements_of_a_group_the_identity_first) {
  const Symmetric cube("cube");
  const std::vector<Symmetry> elements = elements_of(cube.group, cube.mesh);
  ASSERT_EQ(elements.size(), 48u);
  EXPECT_EQ(elements[0].isometry, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  for (const Symmetry& element : elements) EXPECT_NEAR(std::abs(element.isometry.determinant()), 1, 1e-12);
  EXPECT_EQ(elements_of(SymmetryGroup(), cube.mesh).size(), 1u);
}

TEST(Subgroup, of_the_identity_alone_is_C1) {
  const Symmetric cube("cube");
  int seen = 0;
  const SymmetryGroup none = subgroup(cube.group, cube.mesh, [&](const Symmetry& s) {
    ++seen;
    return (s.isometry - Eigen::Matrix3d::Identity()).norm() < 1e-9;
  });
  EXPECT_EQ(seen, 48);
  EXPECT_EQ(none.name, "C1");
  EXPECT_EQ(none.order, 1);
  EXPECT_TRUE(none.generators.empty());
}

TEST(Subgroup, that_keeps_a_face_has_its_order_and_maps_points_to_points) {
  for (const char* name : {"cube", "two-3", "torus"}) {
    SCOPED_TRACE(name);
    const Symmetric s(name);
    const SymmetryGroup kept = s.keeping_face(0);
    const Orbits orbits = face_orbits(s.mesh, s.group);
    EXPECT_EQ(kept.order * orbits.sizes[orbits.of[0]], s.group.order);  // orbit and stabilizer
    for (const Symmetry& generator : kept.generators) {
      EXPECT_EQ(image_of_face(s.mesh, generator.map, 0), 0);
      for (int v = 0; v < s.mesh.vertex_count(); ++v) {
        const Vector3 image = kept.center + generator.isometry * (s.cage.vertices.row(v).transpose() - kept.center);
        const Vector3 there = s.cage.vertices.row(image_of_vertex(s.mesh, generator.map, v));
        EXPECT_LT((image - there).norm(), 1e-12);
      }
    }
  }
}

TEST(Subgroup, of_the_rotations_of_a_cube_is_O) {
  const Symmetric cube("cube");
  const SymmetryGroup rotations = subgroup(cube.group, cube.mesh, [](const Symmetry& s) { return !s.map.reverses; });
  EXPECT_EQ(rotations.name, "O");
  EXPECT_EQ(rotations.order, 24);
}

}  // namespace
}  // namespace umbilic
