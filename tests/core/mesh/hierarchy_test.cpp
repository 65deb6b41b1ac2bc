// SPDX-License-Identifier: MIT
/// \file
/// How many steps a cage needs, and which cages are refused.
#include "mesh/hierarchy.h"

#include <gtest/gtest.h>

#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

int level_of(const Cage& cage) { return required_level(PolygonMesh(cage)).value(); }

std::string refusal_of(const Cage& cage) {
  const Result<int> level = required_level(PolygonMesh(cage));
  return level ? "" : level.error().message;
}

/// Two apexes, the last two vertices, of valence n, and n triangles around each; valence 4 elsewhere.
Cage bipyramid(int n) {
  Cage cage{Points::Zero(n + 2, 3), {}};
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    cage.faces.push_back({i, next, n});
    cage.faces.push_back({next, i, n + 1});
  }
  return cage;
}

TEST(RequiredLevel, is_1_for_quads_with_neighbouring_extraordinary_vertices) {
  EXPECT_EQ(level_of(cube()), 1);
  EXPECT_EQ(level_of(trapezohedron(6)), 1);
}

TEST(RequiredLevel, is_2_where_polygons_touch_extraordinary_vertices) {
  EXPECT_EQ(level_of(tetrahedron()), 2);
  EXPECT_EQ(level_of(prism(3)), 2);
  EXPECT_EQ(level_of(prism(5)), 2);
  EXPECT_EQ(level_of(bipyramid(7)), 2) << "triangles between apexes";
}

TEST(RequiredLevel, is_1_for_triangles_around_vertices_of_valence_4) {
  EXPECT_EQ(level_of(bipyramid(4)), 1) << "the octahedron: only the face points become extraordinary";
}

TEST(RequiredLevel, is_the_first_level_that_is_evaluable) {
  for (const Cage& cage : {tetrahedron(), cube(), prism(4), prism(6), trapezohedron(5), bipyramid(4), bipyramid(6)}) {
    const int level = level_of(cage);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(is_evaluable(refined(cage, i).mesh), i >= level) << "level " << i;
  }
}

TEST(RequiredLevel, is_0_once_it_has_been_reached) {
  for (const Cage& cage : {tetrahedron(), cube(), prism(5)}) {
    EXPECT_EQ(required_level(refined(cage, level_of(cage)).mesh).value(), 0);
  }
}

TEST(RequiredLevel, refuses_a_vertex_of_valence_2_and_names_it) {
  // A cube with a vertex in the middle of an edge.
  Cage cage = cube();
  cage.vertices.conservativeResize(9, 3);
  cage.vertices.row(8) << 0, -1, -1;
  cage.faces[0] = {0, 3, 2, 1, 8};
  cage.faces[2] = {0, 8, 1, 5, 4};
  EXPECT_EQ(refusal_of(cage), "vertex 9 has valence 2; the limit surface is evaluated for valences 3 to 24");
}

TEST(RequiredLevel, takes_valence_24_and_refuses_25_and_names_the_vertex) {
  EXPECT_EQ(level_of(trapezohedron(24)), 1);
  EXPECT_EQ(refusal_of(trapezohedron(25)),
            "vertex 51 has valence 25; the limit surface is evaluated for valences 3 to 24");
}

TEST(RequiredLevel, takes_a_face_of_24_sides_and_refuses_25_and_names_the_face) {
  EXPECT_EQ(level_of(prism(24)), 2);
  EXPECT_EQ(refusal_of(prism(25)),
            "face 1 has 25 sides and would become a vertex of that valence; at most 24 are possible");
}

}  // namespace
}  // namespace umbilic::test
