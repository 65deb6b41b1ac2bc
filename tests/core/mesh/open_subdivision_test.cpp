// SPDX-License-Identifier: MIT
/// \file
/// Open meshes: roles, one ring of ghosts at every level, and the rules of Catmull-Clark with boundary.
#include "mesh/open_subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mesh/boundary.h"
#include "mesh/components.h"
#include "mesh/hierarchy.h"
#include "mesh/open_cages.h"

namespace umbilic::test {
namespace {

std::map<std::string, Cage> all_open_cages() {
  std::map<std::string, Cage> cages = tame_open_cages();
  cages.merge(wild_open_cages());
  cages.merge(holed_cages());
  return cages;
}

/// One step with the boundary's rules, through maps of vertex pairs: the second implementation. Vertices are those of
/// the vertices, the edges (sorted by their ends) and the faces.
Cage naive_open_step(const Cage& cage) {
  const auto at = [&](int v) -> Vector3 { return cage.vertices.row(v).transpose(); };
  std::vector<Vector3> face_points;
  std::map<std::pair<int, int>, std::vector<Vector3>> beside;
  std::map<int, std::vector<Vector3>> around;
  for (const std::vector<int>& face : cage.faces) {
    Vector3 sum = Vector3::Zero();
    for (const int v : face) sum += at(v);
    face_points.push_back(sum / static_cast<double>(face.size()));
    for (std::size_t i = 0; i < face.size(); ++i) {
      beside[std::minmax(face[i], face[(i + 1) % face.size()])].push_back(face_points.back());
      around[face[i]].push_back(face_points.back());
    }
  }
  std::map<std::pair<int, int>, Vector3> edge_points;
  std::map<int, std::vector<Vector3>> midpoints, rim;
  for (const auto& [edge, points] : beside) {
    const Vector3 middle = (at(edge.first) + at(edge.second)) / 2;
    edge_points[edge] = points.size() == 1 ? middle : Vector3(middle / 2 + (points[0] + points[1]) / 4);
    for (const int v : {edge.first, edge.second}) {
      midpoints[v].push_back(middle);
      if (points.size() == 1) rim[v].push_back(at(v == edge.first ? edge.second : edge.first));
    }
  }
  const auto mean = [](const std::vector<Vector3>& points) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& p : points) sum += p;
    return Vector3(sum / static_cast<double>(points.size()));
  };
  std::vector<Vector3> points;
  for (int v = 0; v < cage.vertices.rows(); ++v) {
    const double n = static_cast<double>(around[v].size());
    if (rim.count(v) == 0) {
      points.push_back(mean(around[v]) / n + 2 * mean(midpoints[v]) / n + (n - 3) / n * at(v));
    } else if (around[v].size() == 1) {
      points.push_back(at(v));
    } else {
      points.push_back(0.75 * at(v) + 0.125 * (rim[v][0] + rim[v][1]));
    }
  }
  std::map<std::pair<int, int>, int> number;
  for (const auto& [edge, point] : edge_points) {
    number[edge] = static_cast<int>(points.size());
    points.push_back(point);
  }
  Cage result;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int>& face = cage.faces[f];
    const std::size_t size = face.size();
    for (std::size_t i = 0; i < size; ++i) {
      result.faces.push_back({face[i], number[std::minmax(face[i], face[(i + 1) % size])],
                              static_cast<int>(points.size()),
                              number[std::minmax(face[i], face[(i + size - 1) % size])]});
    }
    points.push_back(face_points[f]);
  }
  result.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) result.vertices.row(static_cast<int>(i)) = points[i].transpose();
  return result;
}

TEST(OpenMesh, of_a_closed_cage_has_no_roles_but_surface) {
  const PolygonMesh mesh(cube());
  EXPECT_FALSE(mesh.is_open());
  EXPECT_EQ(mesh.surface_face_count(), 6);
  EXPECT_EQ(mesh.surface_halfedge_count(), 24);
  EXPECT_TRUE(boundary_loops(mesh).empty());
  EXPECT_TRUE(bare_vertices(mesh).empty());
}

TEST(OpenMesh, is_closed_by_one_outer_face_for_each_loop) {
  const PolygonMesh mesh(tube(5, 3));
  EXPECT_EQ(mesh.surface_face_count(), 15);
  EXPECT_EQ(mesh.ghost_face_count(), 0);
  ASSERT_EQ(mesh.face_count(), 17);
  for (const int f : {15, 16}) {
    EXPECT_EQ(mesh.role(f), FaceRole::kOuter);
    EXPECT_EQ(mesh.face_size(f), 5);
  }
  EXPECT_EQ(mesh.euler_characteristic(), 0);
  for (int h = 0; h < mesh.halfedge_count(); ++h) EXPECT_EQ(mesh.twin(mesh.twin(h)), h);
}

TEST(OpenMesh, has_holes_after_its_surface) {
  const PolygonMesh mesh(with_holes(cube(), {2}));
  EXPECT_EQ(mesh.surface_face_count(), 5);
  EXPECT_EQ(mesh.ghost_face_count(), 1);
  EXPECT_EQ(mesh.face_count(), 6);
  EXPECT_EQ(mesh.origin(mesh.halfedge(5, 0)), 0);  // of the cage's face 2
  EXPECT_EQ(mesh.euler_characteristic(), 1);
  EXPECT_TRUE(bare_vertices(mesh).empty());
}

TEST(OpenMesh, keeps_its_characteristic_and_its_loops_at_every_level) {
  for (const auto& [name, cage] : all_open_cages()) {
    SCOPED_TRACE(name);
    PolygonMesh mesh(cage);
    const int characteristic = mesh.euler_characteristic();
    const std::size_t loops = boundary_loops(mesh).size();
    const MeshComponents components = find_components(mesh);
    for (int level = 1; level <= 3; ++level) {
      const int faces = mesh.surface_halfedge_count();
      mesh = catmull_clark_mesh(mesh);
      EXPECT_EQ(mesh.surface_face_count(), faces);
      EXPECT_EQ(mesh.euler_characteristic(), characteristic);
      EXPECT_EQ(boundary_loops(mesh).size(), loops);
      EXPECT_EQ(find_components(mesh).genera, components.genera);
      EXPECT_EQ(find_components(mesh).boundaries, components.boundaries);
    }
  }
}

TEST(OpenMesh, has_one_complete_ring_of_ghost_quads_from_level_1_on) {
  for (const auto& [name, cage] : all_open_cages()) {
    SCOPED_TRACE(name);
    PolygonMesh mesh(cage);
    for (int level = 1; level <= 3; ++level) {
      mesh = catmull_clark_mesh(mesh);
      EXPECT_TRUE(bare_vertices(mesh).empty());
      EXPECT_TRUE(is_evaluable(mesh) || level == 1);
      bool surface_ended = false;
      for (int v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_GE(mesh.outgoing(v), 0) << "every vertex is used";
        surface_ended = surface_ended || !mesh.on_surface(v);
        EXPECT_NE(mesh.on_surface(v), surface_ended) << "vertices of the surface come first";
      }
      for (int f = mesh.surface_face_count(); f < mesh.face_count(); ++f) {
        if (mesh.role(f) != FaceRole::kGhost) continue;
        ASSERT_EQ(mesh.face_size(f), 4);
        int touching = 0;
        for (int i = 0; i < 4; ++i) touching += mesh.on_surface(mesh.origin(mesh.halfedge(f, i)));
        EXPECT_GE(touching, 1);
      }
    }
  }
}

TEST(OpenMesh, doubles_the_faces_of_a_boundary_vertex_but_at_corners) {
  for (int k = 1; k <= 8; ++k) {
    const PolygonMesh mesh = catmull_clark_mesh(PolygonMesh(k == 1 ? sheet(1, 1) : half_disc(k)));
    EXPECT_EQ(surface_valence(mesh, 0), k);
    EXPECT_EQ(mesh.valence(0), k == 1 ? 4 : 2 * k);
  }
}

TEST(OpenStep, every_row_sums_to_one) {
  for (const auto& [name, cage] : all_open_cages()) {
    SCOPED_TRACE(name);
    PolygonMesh mesh(cage);
    for (int level = 1; level <= 2; ++level) {
      Refinement step = catmull_clark(mesh);
      ASSERT_EQ(step.stencil.rows(), step.mesh.vertex_count());
      const Eigen::VectorXd sums = step.stencil * Eigen::VectorXd::Ones(mesh.vertex_count());
      EXPECT_LT((sums.array() - 1).abs().maxCoeff(), 1e-14);  // weights of size 4
      mesh = std::move(step.mesh);
    }
  }
}

TEST(OpenStep, with_regular_boundary_and_corners_is_the_standard_step_with_boundary_at_every_level) {
  for (auto [name, cage] : tame_open_cages()) {
    SCOPED_TRACE(name);
    cage.vertices += 0.1 * Random(3).points(cage.vertices.rows());
    Refined extended{PolygonMesh(cage), cage.vertices};
    for (int level = 1; level <= 4; ++level) {
      extended = refined(extended.mesh, extended.control, 1);
      cage = naive_open_step(cage);
      const Points surface = extended.control.topRows(cage.vertices.rows());
      EXPECT_LT((surface - cage.vertices).cwiseAbs().maxCoeff(), 1e-14) << "level " << level;  // a few roundings each
      ASSERT_EQ(extended.mesh.surface_face_count(), static_cast<int>(cage.faces.size()));
      for (std::size_t f = 0; f < cage.faces.size(); ++f) {
        for (int i = 0; i < 4; ++i) {
          ASSERT_EQ(extended.mesh.origin(extended.mesh.halfedge(static_cast<int>(f), i)), cage.faces[f][i]);
        }
      }
    }
  }
}

/// The distance from a point to the nearest point of a segment.
double distance(const Vector3& point, const Vector3& a, const Vector3& b) {
  const double t = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (point - a - t * (b - a)).norm();
}

TEST(OpenStep, leaves_the_standard_curve_by_less_than_a_fiftieth_of_an_edge_where_three_faces_or_more_meet) {
  for (int k = 3; k <= 8; ++k) {
    Cage cage = half_disc(k);
    Refined extended{PolygonMesh(cage), cage.vertices};
    for (int level = 1; level <= 5; ++level) {
      extended = refined(extended.mesh, extended.control, 1);
      cage = naive_open_step(cage);
    }
    const PolygonMesh& mesh = extended.mesh;
    const std::vector<std::vector<int>> loops = boundary_loops(mesh);
    ASSERT_EQ(loops.size(), 1u);
    double worst = 0;
    for (const int h : loops[0]) {
      const Vector3 point = extended.control.row(mesh.origin(h)).transpose();
      double nearest = 1;
      for (const int g : loops[0]) {
        nearest = std::min(nearest, distance(point, cage.vertices.row(mesh.origin(g)).transpose(),
                                             cage.vertices.row(mesh.target(g)).transpose()));
      }
      worst = std::max(worst, nearest);
    }
    EXPECT_LT(worst, 0.02) << k << " faces";
    EXPECT_GT(worst, 1e-4) << "it is not the standard curve";
  }
}

TEST(OpenStep, of_a_holed_cage_is_the_step_of_the_closed_one_on_the_surface) {
  for (auto [name, cage] : holed_cages()) {
    SCOPED_TRACE(name);
    if (name == "sheet within a sheet") continue;  // the whole is open
    cage.vertices += 0.1 * Random(4).points(cage.vertices.rows());
    Cage whole = cage;
    whole.holes.clear();
    const Refined holed = refined(cage, 3), closed = refined(whole, 3);
    std::set<std::array<double, 3>> points;
    const auto key = [](const Points& p, int v) {
      return std::array{std::round(1e10 * p(v, 0)), std::round(1e10 * p(v, 1)), std::round(1e10 * p(v, 2))};
    };
    for (int v = 0; v < closed.mesh.vertex_count(); ++v) points.insert(key(closed.control, v));
    int matched = 0;
    for (int v = 0; v < holed.mesh.vertex_count(); ++v)
      matched += static_cast<int>(points.count(key(holed.control, v)));
    EXPECT_GE(matched, holed.mesh.vertex_count() - 1);  // one may round the other way
  }
}

TEST(RequiredLevel, of_an_open_cage_is_one_at_least_and_of_one_with_its_ghosts_none) {
  EXPECT_EQ(required_level(PolygonMesh(sheet(3, 3))).value(), 1);
  EXPECT_EQ(required_level(PolygonMesh(half_disc(5))).value(), 1);
  EXPECT_EQ(required_level(PolygonMesh(polygon(6))).value(), 1);
  EXPECT_EQ(required_level(PolygonMesh(holed_cages().at("sheet within a sheet"))).value(), 0);
}

TEST(RequiredLevel, refuses_a_vertex_at_which_holes_meet) {
  EXPECT_EQ(required_level(PolygonMesh(with_holes(sheet(4, 4), {5, 10}))).error().message,
            "vertex 13 joins 2 fans of faces with holes between them: not a manifold");
}

TEST(RequiredLevel, refuses_a_boundary_vertex_of_more_than_12_faces) {
  EXPECT_TRUE(required_level(PolygonMesh(half_disc(12))).ok());
  EXPECT_EQ(required_level(PolygonMesh(half_disc(13))).error().message,
            "vertex 1 has 13 faces and lies on the boundary, where at most 12 are possible");
}

}  // namespace
}  // namespace umbilic::test
