// SPDX-License-Identifier: MIT
/// \file
/// Filled loops: closed, of quads, oriented with the rest, smooth, and as symmetric as what they fill.
#include "cage/fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "cage/edges.h"
#include "cage/generate.h"
#include "filling.h"

namespace umbilic::test {
namespace {

using std::numbers::pi;

TEST(Fill, closes_both_ends_of_a_tube_of_any_number_of_sides_to_a_sphere_of_quads) {
  for (const int n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 22, 26, 30, 40, 41}) {
    SCOPED_TRACE(n);
    const FilledCage filled = expect_closed(tube(n, 2));
    EXPECT_EQ(filled.loops.size(), 2u);
    EXPECT_EQ(filled.refined.has_value(), n % 2 != 0);
    EXPECT_EQ(euler_characteristic(filled.cage), 2);
    const double edge = 2 * std::sin(pi / n) / (filled.refined ? 2 : 1);
    EXPECT_GT(shortest_distance(filled.cage.vertices), 0.25 * edge) << "vertices stay apart";
  }
}

TEST(Fill, leaves_the_vertices_of_a_smooth_loop_regular_and_makes_few_others) {
  const auto expect = [](int n, const std::map<int, int>& extraordinary) {
    const FilledCage filled = expect_closed(tube(n, 2));
    const std::vector<int> valence = edge_counts(filled.cage);
    for (const FilledLoop& loop : filled.loops) {
      std::map<int, int> found;
      for (const int v : loop.vertices) {
        if (valence[v] != 4) ++found[valence[v]];
      }
      EXPECT_EQ(found, extraordinary) << n;
      for (const int v : loop.vertices) EXPECT_GE(valence[v], 3);
    }
    const int first = filled.loops[0].vertices.front();
    for (int v = 0; v < first; ++v) EXPECT_EQ(valence[v], 4) << n;
  };
  for (const int n : {4, 8, 12, 14, 22, 40}) expect(n, {{3, 4}});
  for (const int n : {5, 10, 30}) expect(n, {{3, 5}, {5, 1}});
  for (const int n : {3, 6, 18}) expect(n, {{3, 4}});
}

TEST(Fill, gives_a_hole_the_vertex_back_whose_faces_were_taken) {
  CageOptions options;
  options.major_segments = 7;
  options.minor_segments = 9;
  const Cage torus = *generate_cage("torus", options);
  const FilledCage filled = expect_closed(without_star(torus, 20));
  EXPECT_EQ(edge_counts(filled.cage).back(), 4);
  EXPECT_EQ(filled.loops[0].faces.size(), 4u);
  // The axis points of a flag cage have valence 2 · arms; each is alone within its quads.
  for (const char* name : {"two-3", "two-5", "tetrahedron-frame"}) {
    const Cage frame = *generate_cage(name);
    const std::vector<int> valence = edge_counts(frame);
    const auto axis = std::max_element(valence.begin(), valence.end()) - valence.begin();
    const FilledCage restored = expect_closed(without_star(frame, static_cast<int>(axis)));
    EXPECT_EQ(restored.loops[0].vertices.size(), 1u) << name;
    EXPECT_EQ(edge_counts(restored.cage).back(), valence[axis]) << name;
    EXPECT_FALSE(restored.refined);
    std::vector<int> again = edge_counts(restored.cage);
    again.erase(again.begin() + axis);
    std::vector<int> before = valence;
    before.erase(before.begin() + axis);
    again.pop_back();
    EXPECT_EQ(again, before) << "all other valences are as they were";
  }
}

TEST(Fill, refines_first_where_a_single_quad_or_triangle_was_taken_out) {
  Cage torus = *generate_cage("torus");
  torus.faces.erase(torus.faces.begin() + 7);
  const FilledCage filled = expect_closed(torus);
  EXPECT_TRUE(filled.refined);
  EXPECT_EQ(filled.loops[0].faces.size(), 4u);
  EXPECT_EQ(filled.loops[0].vertices.size(), 1u);
  for (const int n : edge_counts(filled.cage)) EXPECT_EQ(n, 4);

  Cage octahedron;
  octahedron.vertices.resize(6, 3);
  octahedron.vertices << 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
  octahedron.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}};
  const FilledCage closed = expect_closed(octahedron);
  EXPECT_TRUE(closed.refined);
  EXPECT_EQ(closed.loops[0].faces.size(), 3u) << "as a step of the octahedron has there";
  EXPECT_EQ(euler_characteristic(closed.cage), 2);
}

TEST(Fill, of_a_flat_hole_is_flat_and_nowhere_folded) {
  for (const int n : {4, 5, 6, 8, 10, 12, 14, 18, 22, 40, 41, 60}) {
    for (const int rows : {1, 3}) {
      FillOptions options;
      const Cage flat = washer(n, rows);
      options.loops = {1};
      const Result<FilledCage> filled = fill(flat, options);
      ASSERT_TRUE(filled.ok()) << filled.error().message;
      EXPECT_EQ(filled->cage.vertices.col(2).cwiseAbs().maxCoeff(), 0);
      for (const int f : filled->loops[0].faces) {
        const std::vector<int>& quad = filled->cage.faces[f];
        for (int i = 0; i < 4; ++i) {
          const Vector3 a = filled->cage.vertices.row(quad[i]), b = filled->cage.vertices.row(quad[(i + 1) % 4]),
                        c = filled->cage.vertices.row(quad[(i + 2) % 4]);
          const double turn = (b - a).cross(c - b).z() / ((b - a).norm() * (c - b).norm());
          EXPECT_GT(turn, 0.2) << n << ", face " << f << ": every corner is convex";
        }
      }
    }
  }
}

TEST(Fill, goes_on_in_the_direction_in_which_the_surface_arrives) {
  for (const double flare : {-0.4, 0., 0.4}) {
    const Cage open = tube(16, 2, flare);
    const FilledCage filled = expect_closed(open);
    for (int i = 0; i < 16; ++i) {
      const Vector3 before = open.vertices.row(16 + i), at = open.vertices.row(32 + i);
      const int across = new_neighbour(filled.cage, 32 + i, 48);
      ASSERT_GE(across, 48);
      const Vector3 after = filled.cage.vertices.row(across);
      EXPECT_GT((at - before).normalized().dot((after - at).normalized()), std::cos(pi / 6)) << "flare " << flare;
    }
    EXPECT_GT(filled.cage.vertices.col(2).maxCoeff(), 1.2) << "a dome over the end";
  }
}

/// Whether the isometry maps the vertices of the cage to vertices, within 1e-12.
bool maps_to_itself(const Cage& cage, const Eigen::Matrix3d& isometry) {
  const Points images = cage.vertices * isometry.transpose();
  for (const auto& image : images.rowwise()) {
    if ((cage.vertices.rowwise() - image).rowwise().norm().minCoeff() > 1e-12) return false;
  }
  return true;
}

TEST(Fill, is_as_symmetric_as_the_patch_and_what_it_fills) {
  const auto turned = [](double angle) { return Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(); };
  const Eigen::Matrix3d mirror = Vector3(1, 1, -1).asDiagonal();
  for (const auto& [n, sides] :
       std::map<int, int>{{3, 3}, {5, 5}, {6, 3}, {8, 4}, {10, 5}, {12, 4}, {18, 3}, {40, 4}}) {
    const FilledCage filled = expect_closed(tube(n, 2));
    EXPECT_TRUE(maps_to_itself(filled.cage, turned(2 * pi / sides))) << n;
    EXPECT_TRUE(maps_to_itself(filled.cage, mirror)) << n;
    EXPECT_TRUE(maps_to_itself(filled.cage, Vector3(1, -1, 1).asDiagonal().toDenseMatrix() * turned(0)) ||
                maps_to_itself(filled.cage, turned(2 * pi / n) * Vector3(1, -1, 1).asDiagonal().toDenseMatrix()))
        << n;
  }
}

TEST(Fill, commutes_with_rotation_and_scale_and_is_the_same_every_time) {
  const Cage open = tube(14, 2, 0.3);
  const FilledCage filled = expect_closed(open);
  EXPECT_EQ(expect_closed(open).cage.vertices, filled.cage.vertices);
  const Eigen::Matrix3d isometry = Eigen::AngleAxisd(1, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  Cage moved = open;
  moved.vertices = 7 * open.vertices * isometry.transpose();
  const Points expected = 7 * filled.cage.vertices * isometry.transpose();
  // The corners may be others among equal ones only if the loop turned equally there, which flare does not change.
  EXPECT_LT((expect_closed(moved).cage.vertices - expected).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Fill, closes_loops_one_edge_apart_and_loops_out_of_plane) {
  const FilledCage lens = expect_closed(tube(8, 1));
  EXPECT_EQ(euler_characteristic(lens.cage), 2);
  Cage bent = tube(12, 2);
  for (int i = 0; i < 12; ++i) bent.vertices(24 + i, 2) += 0.8 * std::cos(4 * pi * i / 12);
  const FilledCage saddle = expect_closed(bent);
  EXPECT_GT(shortest_distance(saddle.cage.vertices), 0.05);

  // Two holes of a torus, side by side: one row of faces is between them.
  CageOptions options;
  options.major_segments = 12;
  options.minor_segments = 8;
  const Cage torus = without_star(without_star(*generate_cage("torus", options), 8 * 2 + 4), 8 * 5 + 4);
  const FilledCage closed = expect_closed(torus);
  EXPECT_EQ(closed.loops.size(), 2u);
  EXPECT_EQ(euler_characteristic(closed.cage), 0);
}

}  // namespace
}  // namespace umbilic::test
