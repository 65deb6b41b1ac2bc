// SPDX-License-Identifier: MIT
/// \file
/// Symmetry groups of cages: their names, their elements, their orbits, and what they do not depend on.
#include "mesh/symmetry.h"

#include <gtest/gtest.h>

#include <numeric>

#include "mesh/group_elements.h"
#include "mesh/symmetric_cages.h"

namespace umbilic::test {
namespace {

void expect_group(const Cage& cage, const std::string& name, int order) {
  const SymmetryGroup group = symmetry_of(cage);
  EXPECT_EQ(group.name, name);
  EXPECT_EQ(group.order, order) << name;
}

/// The same surface with vertices, faces and corners in another order.
Cage relabelled(const Cage& cage, unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<int> position(cage.vertices.rows());
  std::iota(position.begin(), position.end(), 0);
  std::shuffle(position.begin(), position.end(), engine);
  Cage result = cage;
  for (std::size_t v = 0; v < position.size(); ++v) {
    result.vertices.row(position[v]) = cage.vertices.row(static_cast<Eigen::Index>(v));
  }
  std::shuffle(result.faces.begin(), result.faces.end(), engine);
  for (std::vector<int>& face : result.faces) {
    for (int& v : face) v = position[v];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(engine() % face.size()), face.end());
  }
  return result;
}

TEST(Symmetry, the_generated_cages_have_the_groups_of_their_graphs_in_both_families) {
  for (const FrameFamily family : {FrameFamily::kHub, FrameFamily::kFlag}) {
    CageOptions options;
    options.family = family;
    options.thickness = 1.1;
    const auto expect = [&](const std::string& cage, const std::string& name, int order) {
      SCOPED_TRACE(cage);
      expect_group(generate_cage(cage, options).value(), name, order);
    };
    for (int n = 3; n <= 12; ++n) expect(fmt::format("two-{}", n), fmt::format("D{}h", n), 4 * n);
    expect("cube", "Oh", 48);
    expect("torus", "D6h", 24);
    expect("tetrahedron-frame", "Td", 24);
    expect("cube-frame", "Oh", 48);
    expect("octahedron-frame", "Oh", 48);
    expect("dodecahedron-frame", "Ih", 120);
    expect("hexagonal-prism-frame", "D6h", 24);
    expect("truncated-tetrahedron-frame", "Td", 24);
  }
}

TEST(Symmetry, a_torus_of_m_by_n_quads_is_a_body_of_revolution_cut_into_m_whatever_n) {
  for (const auto& [major, minor] : {std::pair{3, 3}, {7, 5}, {12, 12}, {1000, 8}}) {
    CageOptions options;
    options.major_segments = major;
    options.minor_segments = minor;
    expect_group(generate_cage("torus", options).value(), fmt::format("D{}h", major), 4 * major);
  }
}

TEST(Symmetry, polyhedra_have_the_groups_of_the_textbook) {
  expect_group(tetrahedron(), "Td", 24);
  expect_group(cube(), "Oh", 48);
  expect_group(prism(3), "D3h", 12);
  expect_group(prism(5), "D5h", 20);
  expect_group(prism(4), "D4h", 16);
  expect_group(trapezohedron(5), "D5d", 20);
  expect_group(trapezohedron(8), "D8d", 32);
  expect_group(transformed(cube(), Vector3(1, 2, 3).asDiagonal()), "D2h", 8);
  expect_group(transformed(cube(), Vector3(1, 2, 2).asDiagonal()), "D4h", 16);
  Cage pyramid = cube();
  pyramid.vertices.bottomRows(4).leftCols(2) *= 0.5;
  expect_group(pyramid, "C4v", 8);
}

TEST(Symmetry, a_cage_distorted_alike_under_a_group_has_that_group) {
  for (const PointGroup& group : point_groups()) {
    SCOPED_TRACE(group.name);
    expect_group(cage_with(group), group.name, group.order);
  }
}

TEST(Symmetry, the_isometries_are_those_of_the_group_that_the_cage_was_made_with) {
  for (const PointGroup& group : point_groups()) {
    const Cage cage = cage_with(group);
    const std::vector<Matrix3> elements = closure(group.generators);
    for (const Symmetry& found : symmetry_of(cage).generators) {
      double nearest = 10;
      for (const Matrix3& g : elements) nearest = std::min(nearest, (g - found.isometry).norm());
      EXPECT_LT(nearest, 1e-14) << group.name;
    }
  }
}

TEST(Symmetry, each_generator_is_an_automorphism_that_moves_the_points_as_its_isometry_does) {
  for (const PointGroup& group : point_groups()) {
    SCOPED_TRACE(group.name);
    const Cage cage = cage_with(group);
    const PolygonMesh mesh(cage);
    const SymmetryGroup found = find_symmetry(mesh, cage.vertices);
    for (const Symmetry& generator : found.generators) {
      expect_automorphism(mesh, generator.map);
      EXPECT_EQ(generator.map.reverses, generator.isometry.determinant() < 0);
      EXPECT_LT(error_of(mesh, cage.vertices, found.center, generator), 1e-14);  // coordinates of size 1
    }
  }
}

TEST(Symmetry, the_generators_generate_as_many_elements_as_the_order_says) {
  for (const PointGroup& group : point_groups()) {
    const Cage cage = cage_with(group);
    const PolygonMesh mesh(cage);
    const SymmetryGroup found = find_symmetry(mesh, cage.vertices);
    const std::vector<Symmetry> elements = all_elements(found, mesh);
    EXPECT_EQ(static_cast<int>(elements.size()), found.order) << group.name;
    EXPECT_LE(1 << found.generators.size(), found.order) << group.name;
  }
}

TEST(Symmetry, name_and_order_survive_rotation_translation_scale_mirroring_and_relabelling) {
  for (const PointGroup& group : point_groups()) {
    SCOPED_TRACE(group.name);
    const Cage cage = cage_with(group);
    expect_group(transformed(cage, some_rotation(), {3, -20, 7}), group.name, group.order);
    expect_group(transformed(cage, 1e-3 * some_rotation()), group.name, group.order);
    expect_group(transformed(cage, 1e6 * some_rotation(), {1e6, 0, 0}), group.name, group.order);
    expect_group(transformed(cage, reflection({1, 2, 3})), group.name, group.order);
    expect_group(relabelled(cage, 7), group.name, group.order);
  }
}

TEST(Symmetry, only_a_chiral_cage_has_no_generator_that_reverses) {
  for (const PointGroup& group : point_groups()) {
    bool chiral = true, reverses = false;
    for (const Matrix3& g : group.generators) chiral = chiral && g.determinant() > 0;
    for (const Symmetry& generator : symmetry_of(cage_with(group)).generators) {
      reverses = reverses || generator.map.reverses;
    }
    EXPECT_EQ(reverses, !chiral) << group.name;
  }
}

TEST(Symmetry, refined_points_of_symmetric_points_are_symmetric_under_the_refined_group) {
  for (const PointGroup& group : point_groups()) {
    SCOPED_TRACE(group.name);
    const Cage cage = cage_with(group);
    PolygonMesh mesh(cage);
    Points points = cage.vertices;
    SymmetryGroup acting = find_symmetry(mesh, points);
    for (int level = 0; level < 2; ++level) {
      acting = refined(acting, mesh);
      Refinement step = catmull_clark(mesh);
      points = (step.stencil * points).eval();
      mesh = std::move(step.mesh);
      for (const Symmetry& generator : acting.generators) {
        expect_automorphism(mesh, generator.map);
        EXPECT_LT(error_of(mesh, points, acting.center, generator), 1e-14);
      }
    }
    EXPECT_EQ(find_symmetry(mesh, points).name, group.name);
  }
}

TEST(Symmetry, refining_a_group_is_refining_each_point_of_any_cage) {
  // The stencil commutes with the vertex maps, whatever the points: refining p after relabelling is relabelling after
  // refining p.
  for (const Cage& cage : {cube(), prism(5), trapezohedron(3), tetrahedron()}) {
    const PolygonMesh mesh(cage);
    const SymmetryGroup group = find_symmetry(mesh, cage.vertices);
    const SymmetryGroup fine = refined(group, mesh);
    const Refinement step = catmull_clark(mesh);
    const Points points = Random(3).points(mesh.vertex_count());
    for (std::size_t g = 0; g < group.generators.size(); ++g) {
      Points moved(points.rows(), 3);
      for (int v = 0; v < mesh.vertex_count(); ++v) {
        moved.row(v) = points.row(image_of_vertex(mesh, group.generators[g].map, v));
      }
      const Points before = step.stencil * moved, after = step.stencil * points;
      for (int v = 0; v < step.mesh.vertex_count(); ++v) {
        const int image = image_of_vertex(step.mesh, fine.generators[g].map, v);
        EXPECT_LT((before.row(v) - after.row(image)).norm(), 1e-15 * 8);  // sums of about 10 terms of size 1
      }
    }
  }
}

TEST(Symmetry, the_orbits_of_faces_partition_them_and_their_sizes_divide_the_order) {
  for (const PointGroup& group : point_groups()) {
    const Cage cage = cage_with(group);
    const PolygonMesh mesh(cage);
    const SymmetryGroup found = find_symmetry(mesh, cage.vertices);
    const Orbits orbits = face_orbits(mesh, found);
    ASSERT_EQ(static_cast<int>(orbits.of.size()), mesh.face_count());
    std::vector<int> counted(orbits.sizes.size(), 0);
    int last = -1;
    for (const int orbit : orbits.of) {
      EXPECT_LE(orbit, last + 1) << "orbits are numbered by their first faces";
      last = std::max(last, orbit);
      ++counted.at(orbit);
    }
    EXPECT_EQ(counted, orbits.sizes);
    for (const int size : orbits.sizes) EXPECT_EQ(found.order % size, 0) << group.name;
    for (const Symmetry& g : found.generators) {
      for (int f = 0; f < mesh.face_count(); ++f) EXPECT_EQ(orbits.of[image_of_face(mesh, g.map, f)], orbits.of[f]);
    }
  }
}

TEST(Symmetry, burnside_counts_the_orbits_of_faces) {
  // The number of orbits is the mean number of faces that an element keeps.
  for (const PointGroup& group : point_groups()) {
    const Cage cage = cage_with(group);
    const PolygonMesh mesh(cage);
    const SymmetryGroup found = find_symmetry(mesh, cage.vertices);
    int kept = 0;
    for (const Symmetry& g : all_elements(found, mesh)) {
      for (int f = 0; f < mesh.face_count(); ++f) kept += image_of_face(mesh, g.map, f) == f;
    }
    EXPECT_EQ(kept, found.order * static_cast<int>(face_orbits(mesh, found).sizes.size())) << group.name;
  }
}

TEST(Symmetry, without_symmetry_every_face_is_an_orbit) {
  Cage cage = prism(5);
  cage.vertices += 0.1 * Random(2).points(10);
  const PolygonMesh mesh(cage);
  const SymmetryGroup group = find_symmetry(mesh, cage.vertices);
  EXPECT_EQ(group.name, "C1");
  EXPECT_TRUE(group.generators.empty());
  EXPECT_EQ(face_orbits(mesh, group).sizes, std::vector<int>(7, 1));
}

}  // namespace
}  // namespace umbilic::test
