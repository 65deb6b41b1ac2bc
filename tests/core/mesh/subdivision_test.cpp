// SPDX-License-Identifier: MIT
/// \file
/// The Catmull-Clark step: stencils, counts, valences, and a second implementation.
#include "mesh/subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "mesh/rough_cages.h"
#include "opinion/plain_step.h"

namespace umbilic::test {
namespace {

std::vector<Cage> rough_polyhedra() {
  std::vector<Cage> cages{tetrahedron(), cube(), prism(3), prism(5), prism(9), trapezohedron(3), trapezohedron(7)};
  Random random(5);
  for (Cage& cage : cages) cage.vertices += 0.2 * random.points(cage.vertices.rows());
  return cages;
}

std::map<int, int> valences(const PolygonMesh& mesh) {
  std::map<int, int> histogram;
  for (int v = 0; v < mesh.vertex_count(); ++v) ++histogram[mesh.valence(v)];
  return histogram;
}

TEST(CatmullClark, every_stencil_sums_to_one_and_has_no_negative_weight) {
  for (const Cage& cage : rough_polyhedra()) {
    const Refinement step = catmull_clark(PolygonMesh(cage));
    // A few additions of numbers of size 1.
    for (int row = 0; row < step.stencil.rows(); ++row) EXPECT_NEAR(step.stencil.row(row).sum(), 1, 1e-15 * 8);
    for (int i = 0; i < step.stencil.nonZeros(); ++i) EXPECT_GT(step.stencil.valuePtr()[i], 0);
  }
}

TEST(CatmullClark, the_matrix_equals_face_edge_and_vertex_points_computed_from_the_definition) {
  for (const Cage& cage : rough_polyhedra()) {
    const PolygonMesh mesh(cage);
    const Points refined = catmull_clark(mesh).stencil * cage.vertices;
    const opinion::PlainStep plain = opinion::plain_step(cage);
    const auto expect_row = [&](int row, const Vector3& expected) {
      EXPECT_LT((refined.row(row).transpose() - expected).norm(), 1e-14) << "row " << row;  // sums of about 10 terms
    };
    ASSERT_EQ(refined.rows(), mesh.vertex_count() + mesh.edge_count() + mesh.face_count());
    for (int v = 0; v < mesh.vertex_count(); ++v) expect_row(v, plain.vertex_points[v]);
    for (int h = 0; h < mesh.halfedge_count(); ++h) {
      expect_row(mesh.vertex_count() + mesh.edge(h), plain.edge_points.at(std::minmax(mesh.origin(h), mesh.target(h))));
    }
    for (int f = 0; f < mesh.face_count(); ++f) {
      expect_row(mesh.vertex_count() + mesh.edge_count() + f, plain.face_points[f]);
    }
  }
}

TEST(CatmullClark, the_corner_of_a_cube_goes_to_5_ninths_its_edges_to_3_quarters_its_faces_stay) {
  const PolygonMesh mesh(cube());
  const Points refined = catmull_clark(mesh).stencil * cube().vertices;
  for (int v = 0; v < 8; ++v) EXPECT_LT((refined.row(v) - cube().vertices.row(v) * 5 / 9).norm(), 1e-15);
  for (int e = 8; e < 20; ++e) EXPECT_NEAR(refined.row(e).norm(), 0.75 * std::sqrt(2), 1e-15);
  for (int f = 20; f < 26; ++f) EXPECT_NEAR(refined.row(f).norm(), 1, 1e-15);
}

TEST(CatmullClark, the_corner_of_a_cube_converges_to_one_half_and_its_face_points_to_68_81sts) {
  // Limit stencil n/(n+5), 4/(n(n+5)), 1/(n(n+5)) (Halstead et al. 1993) by hand: at the cube's corner 3/8 (1, 1, 1) +
  // 1/6 (1, 1, 1) - 1/24 (1, 1, 1) = 1/2; at a face point of level 1 4/9 + 4/9 * 3/4 + 1/9 * 5/9 = 68/81.
  const Refined deep = refined(cube(), 6);
  const Refined first = refined(cube(), 1);
  for (int v = 0; v < 8; ++v) {
    // Control points tend to their limits like 4^-level.
    EXPECT_LT((deep.control.row(v) - cube().vertices.row(v) / 2).norm(), 1e-3);
  }
  for (int f = 20; f < 26; ++f) EXPECT_NEAR(deep.control.row(f).norm(), 68.0 / 81, 1e-3);
}

TEST(CatmullClark, commutes_with_affine_maps) {
  const Eigen::Matrix3d linear = Random(3).matrix<Eigen::Matrix3d>(3, 3);
  const Eigen::RowVector3d shift(3, -1, 2);
  for (const Cage& cage : rough_polyhedra()) {
    const SparseMatrix stencil = catmull_clark(PolygonMesh(cage)).stencil;
    const Points mapped = (cage.vertices * linear).rowwise() + shift;
    const Points before = stencil * mapped;
    const Points after = ((stencil * cage.vertices) * linear).rowwise() + shift;
    EXPECT_LT((before - after).norm(), 1e-13);  // about 50 rows of size 5
  }
}

TEST(CatmullClark, keeps_the_euler_characteristic_and_turns_every_corner_into_a_quad) {
  for (const Cage& cage : rough_polyhedra()) {
    PolygonMesh mesh(cage);
    for (int level = 0; level < 3; ++level) {
      EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() + mesh.face_count(), 2);
      const PolygonMesh next = catmull_clark(mesh).mesh;
      EXPECT_EQ(next.face_count(), mesh.halfedge_count());
      for (int f = 0; f < next.face_count(); ++f) EXPECT_EQ(next.face_size(f), 4);
      mesh = next;
    }
  }
}

TEST(CatmullClark, keeps_valences_of_vertices_gives_edges_4_and_faces_their_number_of_sides) {
  for (const Cage& cage : rough_polyhedra()) {
    const PolygonMesh mesh(cage);
    std::map<int, int> expected = valences(mesh);
    expected[4] += mesh.edge_count();
    for (int f = 0; f < mesh.face_count(); ++f) ++expected[mesh.face_size(f)];
    const PolygonMesh once = catmull_clark(mesh).mesh;
    EXPECT_EQ(valences(once), expected);
    expected[4] += once.edge_count() + once.face_count();
    EXPECT_EQ(valences(catmull_clark(once).mesh), expected) << "quads add no extraordinary vertex";
  }
}

TEST(CatmullClark, the_quad_of_a_halfedge_starts_at_its_origin_and_runs_along_it) {
  const PolygonMesh mesh(prism(5));
  const PolygonMesh next = catmull_clark(mesh).mesh;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const int corner = next.halfedge(h, 0);
    EXPECT_EQ(next.origin(corner), mesh.origin(h));
    EXPECT_EQ(next.target(corner), mesh.vertex_count() + mesh.edge(h));
    EXPECT_EQ(next.origin(corner + 2), mesh.vertex_count() + mesh.edge_count() + mesh.face(h));
  }
}

}  // namespace
}  // namespace umbilic::test
