// SPDX-License-Identifier: MIT
/// \file
/// What can be asked of a fill, and what it tells: loops, corners, holes, numbers and groups.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cage/fill.h"
#include "cage/generate.h"
#include "filling.h"

namespace umbilic::test {
namespace {

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
  EXPECT_EQ(groups[1].faces.size(), 18u) << "half of the quads of the faces at the loop: all quads would leave no rest";
  EXPECT_EQ(groups[1].faces, filled.loops[0].rim);
  EXPECT_EQ(groups[2].faces, (std::vector<int>{36, 37, 38, 39})) << "the quads of the face";
  EXPECT_EQ(groups[3].name, "fill-3-rim");
  EXPECT_EQ(groups[4].name, "fill-1");
  EXPECT_EQ(groups[4].faces, filled.loops[0].faces);
  EXPECT_EQ(groups[5].name, "fill-3");
  EXPECT_EQ(filled.loops[1].group, "fill-3");
}

/// The step's rules for boundaries move the loop, which no other face may depend on.
TEST(Fill, of_a_refined_cage_has_all_quads_of_the_faces_at_its_loop_as_its_rim) {
  const Cage cage = tube(9, 3);
  const FilledCage filled = expect_closed(cage);
  ASSERT_TRUE(filled.refined);
  ASSERT_EQ(filled.loops.size(), 2u);
  std::set<int> of_loop;
  for (const FilledLoop& loop : filled.loops) {
    EXPECT_EQ(loop.rim.size(), 36u);
    for (const int f : loop.rim) of_loop.insert(f);
  }
  EXPECT_EQ(of_loop.size(), 72u);
  for (int f = 0; f < 108; ++f) {
    if (of_loop.count(f) > 0) continue;
    for (const int v : filled.cage.faces[f]) {
      const auto at = std::find(filled.vertex_numbers.begin(), filled.vertex_numbers.end(), v);
      if (at == filled.vertex_numbers.end()) continue;
      const auto row = (at - filled.vertex_numbers.begin()) / 9;
      EXPECT_TRUE(row == 1 || row == 2) << "no end of the tube is a corner of the rest";
    }
  }
}

}  // namespace
}  // namespace umbilic::test
