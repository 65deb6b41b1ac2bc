// SPDX-License-Identifier: MIT
/// \file
/// Points and tangents of the limit surface as stencils: against deep subdivision, and the same on every level.
#include "surface/limit_stencil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/rough_cages.h"
#include "surface/deep_subdivision.h"

namespace umbilic::test {
namespace {

/// Rough closed meshes: with triangles, with quads of several extraordinary vertices, evaluable, small.
std::vector<std::pair<const char*, Refined>> rough_meshes() {
  std::vector<std::pair<const char*, Refined>> meshes;
  const auto add = [&](const char* name, const Cage& cage, int steps) {
    Refined mesh = refined(cage, steps);
    mesh.control += 0.05 * Random(7).points(mesh.control.rows());
    meshes.emplace_back(name, std::move(mesh));
  };
  add("tetrahedron", tetrahedron(), 0);
  add("cube", cube(), 0);
  add("cube refined", cube(), 1);
  add("prism", prism(5), 0);
  add("prism refined", prism(7), 2);
  add("trapezohedron", trapezohedron(5), 0);
  return meshes;
}

/// Vertices, corners, edges, and points inside of some faces.
std::vector<SurfacePlace> places_on(const PolygonMesh& mesh) {
  std::vector<SurfacePlace> places;
  for (int v = 0; v < mesh.vertex_count(); v += 1 + mesh.vertex_count() / 9) places.push_back({.vertex = v});
  const double points[][2] = {{0.3, 0.1}, {0.7, 0.2}, {0.9, 0.6}, {0.2, 0.8}, {0.5, 0},
                              {0, 0.25},  {0, 0},     {1, 0},     {1, 1}};
  for (int h = 0; h < mesh.halfedge_count(); h += 1 + mesh.halfedge_count() / 31) {
    for (const auto& [u, v] : points) places.push_back({.halfedge = h, .u = u, .v = v});
  }
  return places;
}

Vector3 normal(const Eigen::Matrix3d& jet) { return jet.col(1).cross(jet.col(2)).normalized(); }

TEST(LimitStencil, of_a_place_is_the_same_on_every_level) {
  for (const auto& [name, mesh] : rough_meshes()) {
    std::vector<SurfacePlace> places = places_on(mesh.mesh);
    const std::vector<LimitStencil> coarse = limit_stencils(mesh.mesh, places);
    Refined level{mesh.mesh, mesh.control};
    for (int step = 1; step <= 3; ++step) {
      for (SurfacePlace& place : places) place = refined(place, level.mesh);
      const Refinement refinement = catmull_clark(level.mesh);
      level = {refinement.mesh, refinement.stencil * level.control};
      const std::vector<LimitStencil> fine = limit_stencils(level.mesh, places);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Matrix3d before = coarse[i].apply(mesh.control), after = fine[i].apply(level.control);
        EXPECT_LT((before.col(0) - after.col(0)).norm(), 1e-14) << name << " " << i << " step " << step;
        const Vector3 n = normal(before);
        EXPECT_LT((n - normal(after)).norm(), 1e-11) << name << " " << i << " step " << step;
        const bool corner =
            places[i].is_vertex() || (places[i].u == std::floor(places[i].u) && places[i].v == std::floor(places[i].v));
        if (corner) continue;
        EXPECT_LT((before - after).norm(), 1e-12 * before.norm()) << name << " " << i << " step " << step;
      }
    }
  }
}

TEST(LimitStencil, in_a_face_agrees_with_deep_subdivision) {
  for (const auto& [name, mesh] : rough_meshes()) {
    std::vector<SurfacePlace> places;
    for (const SurfacePlace& place : places_on(mesh.mesh)) {
      const bool corner = (place.u == 0 || place.u == 1) && (place.v == 0 || place.v == 1);
      if (!place.is_vertex() && !corner && mesh.mesh.face_size(mesh.mesh.face(place.halfedge)) == 4)
        places.push_back(place);
    }
    if (mesh.mesh.halfedge_count() != 4 * mesh.mesh.face_count()) continue;
    const DeepSubdivision deep(mesh.mesh, mesh.control);
    const std::vector<LimitStencil> stencils = limit_stencils(mesh.mesh, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const SurfaceJet expected = deep.jet(places[i].halfedge, places[i].u, places[i].v);
      const Eigen::Matrix3d actual = stencils[i].apply(mesh.control);
      EXPECT_LT((actual.transpose() - expected.topRows<3>()).norm(), 1e-12) << name << " " << i;
    }
  }
}

TEST(LimitStencil, at_a_vertex_is_the_limit_of_the_refined_vertices) {
  for (const auto& [name, mesh] : rough_meshes()) {
    std::vector<SurfacePlace> places;
    for (int v = 0; v < mesh.mesh.vertex_count(); v += 3) places.push_back({.vertex = v});
    const std::vector<LimitStencil> stencils = limit_stencils(mesh.mesh, places);
    Refined level{mesh.mesh, mesh.control};
    for (int step = 0; step < 4; ++step) {
      const Refinement refinement = catmull_clark(level.mesh);
      level = {refinement.mesh, refinement.stencil * level.control};
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const int v = places[i].vertex;
      const Eigen::Matrix3d jet = stencils[i].apply(mesh.control);
      double edge = 0;
      Vector3 area = Vector3::Zero();  // of the faces around the refined vertex
      int h = level.mesh.outgoing(v);
      do {
        const Vector3 a = level.control.row(level.mesh.target(h)) - level.control.row(v);
        h = level.mesh.rotate(h);
        const Vector3 b = level.control.row(level.mesh.target(h)) - level.control.row(v);
        edge = std::max(edge, a.norm());
        area += a.cross(b);
      } while (h != level.mesh.outgoing(v));
      EXPECT_LT((jet.col(0).transpose() - level.control.row(v)).norm(), edge) << name << " " << v;
      EXPECT_GT(normal(jet).dot(area.normalized()), 0.95) << name << " " << v << ": the normal points outward";
    }
  }
}

TEST(LimitStencil, moves_with_the_control_points) {
  const Refined mesh = refined(prism(5), 1);
  const Eigen::Matrix3d turn = some_rotation();
  const Vector3 shift(1, 2, 3);
  const Points moved = (mesh.control * turn.transpose()).rowwise() + shift.transpose();
  const std::vector<SurfacePlace> places = places_on(mesh.mesh);
  for (const LimitStencil& stencil : limit_stencils(mesh.mesh, places)) {
    EXPECT_NEAR(stencil.weights.row(0).sum(), 1, 1e-14);
    EXPECT_LT(stencil.weights.bottomRows<2>().rowwise().sum().norm(), 1e-12);
    EXPECT_TRUE(std::is_sorted(stencil.points.begin(), stencil.points.end()));
    const Eigen::Matrix3d before = stencil.apply(mesh.control), after = stencil.apply(moved);
    EXPECT_LT((after.col(0) - turn * before.col(0) - shift).norm(), 1e-14);
    EXPECT_LT((after.rightCols<2>() - turn * before.rightCols<2>()).norm(), 1e-12);
  }
}

TEST(LimitStencil, of_the_other_half_edges_of_a_quad_is_the_same_point) {
  const Refined mesh = refined(trapezohedron(5), 1);
  for (int f = 0; f < mesh.mesh.face_count(); ++f) {
    const int h = mesh.mesh.halfedge(f, 0), next = mesh.mesh.next(h);
    const std::vector<LimitStencil> two =
        limit_stencils(mesh.mesh, {{.halfedge = h, .u = 0.3, .v = 0.2}, {.halfedge = next, .u = 0.2, .v = 0.7}});
    const Eigen::Matrix3d a = two[0].apply(mesh.control), b = two[1].apply(mesh.control);
    EXPECT_LT((a.col(0) - b.col(0)).norm(), 1e-14);
    EXPECT_LT((a.col(1) + b.col(2)).norm(), 1e-12);
    EXPECT_LT((a.col(2) - b.col(1)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace umbilic::test
