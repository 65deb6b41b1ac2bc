// SPDX-License-Identifier: MIT
/// \file
/// The half-edge structure: its permutations and its counts.
#include "mesh/polygon_mesh.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

std::vector<Cage> polyhedra() { return {tetrahedron(), cube(), prism(3), prism(5), prism(12), trapezohedron(8)}; }

TEST(PolygonMesh, twin_is_an_involution_without_fixed_points_that_reverses_each_edge) {
  for (const Cage& cage : polyhedra()) {
    const PolygonMesh mesh(cage);
    for (int h = 0; h < mesh.halfedge_count(); ++h) {
      EXPECT_NE(mesh.twin(h), h);
      EXPECT_EQ(mesh.twin(mesh.twin(h)), h);
      EXPECT_EQ(mesh.origin(mesh.twin(h)), mesh.target(h));
      EXPECT_EQ(mesh.target(mesh.twin(h)), mesh.origin(h));
      EXPECT_EQ(mesh.edge(mesh.twin(h)), mesh.edge(h));
    }
  }
}

TEST(PolygonMesh, next_goes_around_each_face_in_the_order_of_the_cage) {
  for (const Cage& cage : polyhedra()) {
    const PolygonMesh mesh(cage);
    for (int f = 0; f < mesh.face_count(); ++f) {
      ASSERT_EQ(mesh.face_size(f), static_cast<int>(cage.faces[f].size()));
      int h = mesh.halfedge(f, 0);
      for (const int corner : cage.faces[f]) {
        EXPECT_EQ(mesh.origin(h), corner);
        EXPECT_EQ(mesh.face(h), f);
        EXPECT_EQ(mesh.previous(mesh.next(h)), h);
        h = mesh.next(h);
      }
      EXPECT_EQ(h, mesh.halfedge(f, 0));
    }
  }
}

TEST(PolygonMesh, rotate_visits_every_edge_of_a_vertex_once) {
  for (const Cage& cage : polyhedra()) {
    const PolygonMesh mesh(cage);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      std::set<int> visited;
      int h = mesh.outgoing(v);
      do {
        EXPECT_EQ(mesh.origin(h), v);
        EXPECT_TRUE(visited.insert(mesh.edge(h)).second);
        h = mesh.rotate(h);
      } while (h != mesh.outgoing(v));
      EXPECT_EQ(static_cast<int>(visited.size()), mesh.valence(v));
    }
  }
}

TEST(PolygonMesh, rotate_turns_counterclockwise_as_seen_from_outside) {
  // Around the cube's corner (1, 1, 1) counterclockwise order is x, y, z.
  const Cage cage = cube();
  const PolygonMesh mesh(cage);
  const int h = mesh.outgoing(6), g = mesh.rotate(h);
  const Vector3 corner = cage.vertices.row(6), a = cage.vertices.row(mesh.target(h)),
                b = cage.vertices.row(mesh.target(g));
  EXPECT_GT((a - corner).cross(b - corner).dot(corner), 0);
}

TEST(PolygonMesh, edges_are_numbered_from_zero_without_gaps_and_euler_holds) {
  for (const Cage& cage : polyhedra()) {
    const PolygonMesh mesh(cage);
    std::multiset<int> numbers;
    for (int h = 0; h < mesh.halfedge_count(); ++h) numbers.insert(mesh.edge(h));
    for (int e = 0; e < mesh.edge_count(); ++e) EXPECT_EQ(numbers.count(e), 2u);
    EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() + mesh.face_count(), 2);
  }
}

}  // namespace
}  // namespace umbilic::test
