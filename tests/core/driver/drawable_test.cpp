// SPDX-License-Identifier: MIT
/// \file
/// Meshes for graphics hardware: triangles that fill the polygons, edges once, positions that keep their digits.
#include "driver/drawable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

/// Enclosed by the triangles.
double volume(const DrawableMesh& mesh) {
  double sum = 0;
  const auto at = [&](std::uint32_t v) {
    return Vector3(mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]);
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    sum += at(mesh.triangles[i]).dot(at(mesh.triangles[i + 1]).cross(at(mesh.triangles[i + 2]))) / 6;
  }
  return sum;
}

TEST(DrawableMesh, of_a_cage_fills_its_polygons_with_fans_and_has_each_edge_once) {
  const DrawableMesh cube = drawable(*generate_cage("cube"));
  EXPECT_EQ(cube.triangles.size(), 3 * 12u);
  EXPECT_DOUBLE_EQ(volume(cube), 8) << "of side 2";
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < cube.edges.size(); i += 2) edges.insert(std::minmax(cube.edges[i], cube.edges[i + 1]));
  EXPECT_EQ(edges.size(), 12u);
  EXPECT_EQ(cube.edges.size(), 2 * 12u);
  EXPECT_TRUE(cube.normals.empty() && cube.curvatures.empty());
}

TEST(DrawableMesh, of_a_limit_surface_has_two_triangles_for_each_quad) {
  RunOptions options;
  options.weights[kBending] = 1;
  const Result<umbilic::Run> run = umbilic::Run::create(*generate_cage("cube"), options);
  const LimitMesh limit = *run->limit_mesh(3);
  const DrawableMesh mesh = drawable(limit);
  EXPECT_EQ(mesh.triangles.size(), 6 * limit.quads.size());
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(3 * mesh.curvatures.size(), 2 * mesh.positions.size());
  EXPECT_TRUE(mesh.edges.empty());
  // The limit surface lies within the convex hull of the cage, and holds what is left of its faces' middles.
  EXPECT_GT(volume(mesh), 1);
  EXPECT_LT(volume(mesh), 8);
}

/// How many triangles are over another face than `faces` says, of a convex cage about the origin whose faces all have
/// the same distance from it: by symmetry, the surface over a face is closer to that face's normal than to any other.
int misplaced(const DrawableMesh& mesh, const Cage& cage) {
  int wrong = 0;
  for (std::size_t t = 0; t < mesh.faces.size(); ++t) {
    Vector3 middle = Vector3::Zero();
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangles[3 * t + i];
      middle += Vector3(mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]) + mesh.centre;
    }
    std::size_t nearest = 0;
    double closest = 0;
    for (std::size_t f = 0; f < cage.faces.size(); ++f) {
      Vector3 normal = Vector3::Zero();
      for (const int v : cage.faces[f]) normal += cage.vertices.row(v).transpose();
      if (const double cosine = middle.dot(normal.normalized()); cosine > closest) nearest = f, closest = cosine;
    }
    wrong += nearest != mesh.faces[t];
  }
  return wrong;
}

TEST(DrawableMesh, knows_the_face_of_the_cage_that_each_triangle_descends_from) {
  Cage tetrahedron;
  tetrahedron.vertices.resize(4, 3);
  tetrahedron.vertices << 1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1;
  tetrahedron.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  ASSERT_TRUE(validate(tetrahedron));
  RunOptions options;
  options.weights[kBending] = 1;
  Cage open = *generate_cage("cube");
  open.holes = {1, 4};
  for (const Cage& cage : {*generate_cage("cube"), tetrahedron, open}) {
    EXPECT_EQ(misplaced(drawable(cage), cage), 0);
    for (const int level : {0, 1, 2, 3}) {
      options.first_level = options.last_level = level;
      const Result<umbilic::Run> run = umbilic::Run::create(cage, options);
      const DrawableMesh limit = drawable(*run->limit_mesh(2)),
                         control = drawable(run->control_mesh(), run->cage_faces());
      for (const DrawableMesh& mesh : {limit, control}) {
        EXPECT_EQ(3 * mesh.faces.size(), mesh.triangles.size());
        EXPECT_EQ(misplaced(mesh, cage), 0) << "level " << level;
      }
    }
  }
}

}  // namespace
}  // namespace umbilic
