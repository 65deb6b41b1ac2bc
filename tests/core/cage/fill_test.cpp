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

namespace umbilic::test {
namespace {

using std::numbers::pi;

/// `rows` + 1 circles of n points, joined by quads that face away from the axis: open at both ends. Its radius is
/// 1 + flare · the distance from the middle.
Cage tube(int n, int rows, double flare = 0) {
  Cage cage;
  cage.vertices.resize(n * (rows + 1), 3);
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < n; ++i) {
      const double z = j - rows / 2., radius = 1 + flare * std::abs(z), angle = 2 * pi * i / n;
      cage.vertices.row(j * n + i) << radius * std::cos(angle), radius * std::sin(angle), z;
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      cage.faces.push_back({j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i});
    }
  }
  return cage;
}

/// A flat ring around a hole of n points on the unit circle.
Cage washer(int n, int rows = 1) {
  Cage cage = tube(n, rows);
  for (auto row : cage.vertices.rowwise()) {
    const double z = row.z() + rows / 2.;
    row *= 1 + 2 * pi / n * (rows - z);
    row.z() = 0;
  }
  return cage;
}

/// The cage without its faces around a vertex.
Cage without_star(Cage cage, int vertex) {
  std::vector<std::vector<int>> kept;
  for (const std::vector<int>& face : cage.faces) {
    if (std::find(face.begin(), face.end(), vertex) == face.end()) kept.push_back(face);
  }
  cage.faces = kept;
  return cage;
}

std::vector<int> edge_counts(const Cage& cage) {
  std::vector<int> counts(cage.vertices.rows(), 0);
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) ++counts[v];
  }
  return counts;
}

/// The neighbour of a vertex that is not below `first`, or -1.
int new_neighbour(const Cage& cage, int vertex, int first) {
  for (const EdgeUse& use : edge_uses(cage)) {
    if (use.low == vertex && use.high >= first) return use.high;
  }
  return -1;
}

double shortest_distance(const Points& points) {
  double shortest = 1e300;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) shortest = std::min(shortest, (points.row(i) - points.row(j)).norm());
  }
  return shortest;
}

int euler_characteristic(const Cage& cage) {
  const std::vector<int> used = edge_counts(cage);
  const auto vertices = used.size() - std::count(used.begin(), used.end(), 0);
  const std::vector<EdgeUse> uses = edge_uses(cage);
  int edges = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) edges += i == 0 || !same_edge(uses[i - 1], uses[i]);
  return static_cast<int>(vertices) - edges + static_cast<int>(cage.faces.size());
}

/// Expects a closed cage whose faces agree and in which what was there is as it was, or refined.
FilledCage expect_closed(const Cage& open, const FillOptions& options = {}) {
  const Result<FilledCage> filled = fill(open, options);
  EXPECT_TRUE(filled.ok()) << filled.error().message;
  if (!filled) return {};
  const Cage& cage = filled->cage;
  Cage validated = cage;
  const Result<CageReport> report = validate(validated);
  EXPECT_TRUE(report.ok()) << report.error().message;
  // Not by `validate`, which would turn them.
  const std::vector<EdgeUse> uses = edge_uses(cage);
  for (std::size_t i = 0; i < uses.size(); i += 2) EXPECT_NE(uses[i].forward, uses[i + 1].forward) << "faces agree";
  std::size_t first = cage.faces.size();
  for (const FilledLoop& loop : filled->loops) {
    for (const int f : loop.faces) EXPECT_EQ(cage.faces[f].size(), 4u);
    first = std::min<std::size_t>(first, loop.faces.front());
    EXPECT_FALSE(loop.vertices.empty());
  }
  if (!filled->refined) {
    for (std::size_t f = 0; f < first; ++f) EXPECT_EQ(cage.faces[f], open.faces[f]);
    EXPECT_EQ(cage.vertices.topRows(open.vertices.rows()), open.vertices) << "to the last bit";
  } else {
    EXPECT_EQ(first, [&] {
      std::size_t corners = 0;
      for (const auto& face : open.faces) corners += face.size();
      return corners;
    }());
  }
  std::size_t added = 0;
  for (const FilledLoop& loop : filled->loops) added += loop.faces.size();
  EXPECT_EQ(first + added, cage.faces.size()) << "new faces are last";
  return *filled;
}

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

TEST(Fill, fills_the_chosen_loops_only) {
  FillOptions options;
  options.loops = {1};
  const Result<FilledCage> cup = fill(tube(8, 2), options);
  ASSERT_TRUE(cup.ok());
  EXPECT_EQ(euler_characteristic(cup->cage), 1);
  ASSERT_EQ(cup->loops.size(), 1u);
  EXPECT_EQ(cup->loops[0].loop, 1);
  EXPECT_EQ(euler_characteristic(expect_closed(cup->cage).cage), 2);
}

TEST(Fill, lays_a_grid_between_four_marked_corners) {
  FillOptions options;
  options.loops = {1};
  options.corners = {{1, {24, 27, 30, 33}}};  // of the second end of 12 points
  const Result<FilledCage> square = fill(tube(12, 2), options);
  ASSERT_TRUE(square.ok()) << square.error().message;
  EXPECT_FALSE(square->refined);
  EXPECT_EQ(square->loops[0].faces.size(), 9u);
  EXPECT_EQ(square->loops[0].vertices.size(), 4u);
  options.corners[0].vertices = {33, 24, 26, 35};
  EXPECT_EQ(fill(tube(12, 2), options).error().message,
            "boundary 2 has sides of 2, 7, 2, 1 edges between its corners, but opposite ones must have equally many");
  options.corners[0].vertices = {24, 26, 30, 32};
  EXPECT_EQ(fill(tube(12, 2), options)->loops[0].faces.size(), 8u);
  // A loop of 4 edges with marked corners gets the quad that refining first avoids.
  const Result<FilledCage> box = fill(tube(4, 1), {{0, 1}, {{0, {0, 1, 2, 3}}, {1, {4, 5, 6, 7}}}});
  ASSERT_TRUE(box.ok());
  EXPECT_EQ(box->cage.faces.size(), 6u) << "a box";
  // Five sides of 2 edges around a middle; of 2, 2, 2, 2 and 4 edges there is none.
  EXPECT_EQ(fill(tube(10, 2), {{1}, {{1, {20, 22, 24, 26, 28}}}})->loops[0].vertices.size(), 1u);
  EXPECT_EQ(fill(tube(12, 2), {{1}, {{1, {24, 26, 28, 30, 32}}}}).error().message,
            "boundary 2 has sides of 2, 2, 2, 2, 4 edges between its corners, which no patch of quads has");
}

TEST(Fill, says_what_cannot_be_filled) {
  const auto error = [](const Cage& cage, const FillOptions& options) { return fill(cage, options).error().message; };
  EXPECT_EQ(error(*generate_cage("cube"), {}), "the cage is closed, and has no boundary to fill");
  EXPECT_EQ(error(tube(8, 1), {{2}, {}}), "there is no boundary 3; the cage has 2");
  EXPECT_EQ(error(tube(8, 1), {{0, 0}, {}}), "boundary 1 is to be filled twice");
  EXPECT_EQ(error(tube(8, 1), {{0}, {{1, {8, 10, 12, 14}}}}), "boundary 2 has marked corners, but is not filled");
  EXPECT_EQ(error(tube(8, 1), {{0}, {{0, {8, 10, 12, 14}}}}),
            "boundary 1 does not pass vertex 9, which is marked as its corner");
  EXPECT_EQ(error(tube(8, 1), {{0}, {{0, {0, 2, 2, 4}}}}), "boundary 1 has vertex 3 as a corner twice");
  EXPECT_EQ(error(tube(8, 1), {{0}, {{0, {0, 2}}}}), "boundary 1 has 2 corners, not 3 to 12");
  EXPECT_EQ(error(tube(202, 1), {}), "boundary 1 has 202 edges; at most 200 are filled");
  // The grid between these corners would join vertices 1 and 3 by its only edge inside; they are joined already.
  Cage fan;
  fan.vertices.resize(6, 3);
  fan.vertices << 0, 0, 0, 1, 0, 0, 2, 1, 0, 2, 2, 0, 1, 3, 0, 0, 2, 0;
  fan.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  EXPECT_EQ(error(fan, {{}, {{0, {1, 2, 4, 5}}}}), "vertices 1 and 4, which the fill would join, are joined already");
}

TEST(Fill, takes_out_the_faces_marked_as_holes_that_a_loop_touches) {
  Cage cage = tube(8, 4);
  for (int f = 0; f < 8; ++f) cage.holes.push_back(f);
  for (int f = 24; f < 32; ++f) cage.holes.push_back(f);
  const Result<FilledCage> both = fill(cage);
  ASSERT_TRUE(both.ok());
  EXPECT_TRUE(both->cage.holes.empty());
  Cage plain = tube(8, 2);
  EXPECT_EQ(both->cage.faces, expect_closed(plain).cage.faces);
  EXPECT_LT((both->cage.vertices - expect_closed(plain).cage.vertices).cwiseAbs().maxCoeff(), 1e-12);
  const Result<FilledCage> one = fill(cage, {{1}, {}});
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(one->cage.holes, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
}

/// What was there is found again by its old number, also where a hole was taken out or the cage refined.
TEST(Fill, tells_the_new_numbers_of_what_was_there) {
  Cage holed = tube(8, 4);
  for (int f = 0; f < 8; ++f) holed.holes.push_back(f);
  const FilledCage taken = *fill(holed);
  EXPECT_EQ(taken.face_numbers[0], -1);
  EXPECT_EQ(taken.vertex_numbers[0], -1);
  for (int f = 8; f < 32; ++f) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(taken.cage.faces[taken.face_numbers[f]][i], taken.vertex_numbers[holed.faces[f][i]]);
    }
  }
  const Cage odd = tube(9, 2);
  const FilledCage refined = *fill(odd);
  ASSERT_TRUE(refined.refined);
  EXPECT_EQ(*refined.refined, "boundary 1 has 9 vertices, and quads close only an even number");
  for (int f = 0; f < 18; ++f) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(refined.cage.faces[refined.face_numbers[f] + i][0], refined.vertex_numbers[odd.faces[f][i]]);
    }
  }
}

TEST(Fill, puts_the_new_faces_of_each_loop_into_a_group_and_keeps_the_others) {
  Cage cage = tube(9, 2);
  cage.groups = {{"lower", {0, 1, 2, 3, 4, 5, 6, 7, 8}}, {"fill-2", {9}}};
  const FilledCage filled = expect_closed(cage);
  ASSERT_TRUE(filled.refined);
  const std::vector<FaceGroup>& groups = filled.cage.groups;
  ASSERT_EQ(groups.size(), 6u);
  EXPECT_EQ(groups[0].name, "lower");
  EXPECT_EQ(groups[0].faces.size(), 36u);
  EXPECT_EQ(groups[0].faces.back(), 35);
  EXPECT_EQ(groups[1].name, "fill-1-rim");
  EXPECT_EQ(groups[1].faces.size(), 18u) << "half of the quads of the faces at the loop";
  EXPECT_EQ(groups[1].faces, filled.loops[0].rim);
  EXPECT_EQ(groups[2].faces, (std::vector<int>{36, 37, 38, 39})) << "the quads of the face";
  EXPECT_EQ(groups[3].name, "fill-3-rim");
  EXPECT_EQ(groups[4].name, "fill-1");
  EXPECT_EQ(groups[4].faces, filled.loops[0].faces);
  EXPECT_EQ(groups[5].name, "fill-3");
  EXPECT_EQ(filled.loops[1].group, "fill-3");
}

}  // namespace
}  // namespace umbilic::test
