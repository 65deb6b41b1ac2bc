// SPDX-License-Identifier: MIT
/// \file
/// Cages with filled boundaries: what is held then, where numbered elements are found again, and what is refused.
#include "problem/run_cage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "problem/text.h"

namespace umbilic {
namespace {

/// A tube of n x rows quads, open at both ends.
std::string tube(int n, int rows) {
  std::string text;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * 3.14159265358979 * i / n;
      text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " " +
              std::to_string(j - rows / 2.) + "\n";
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      for (const int v : {j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i}) {
        text += (v == j * n + i ? "f " : " ") + std::to_string(v + 1);
      }
      text += "\n";
    }
  }
  return text;
}

Problem filling(std::string text, FillRequest fill = {}) {
  return {.cage = CageText{"t.obj", std::move(text)}, .fill = std::move(fill)};
}

std::string fill_error(Problem problem) {
  const Result<RunCage> cage = run_cage(problem);
  return cage ? "" : cage.error().message;
}

TEST(RunCage, of_a_problem_that_fills_nothing_is_its_cage) {
  Problem problem{.cage = GeneratedCage{"cube", {}}};
  EXPECT_EQ(run_cage(problem)->cage.faces, generate_cage("cube")->faces);
  EXPECT_FALSE(problem.constraints.any());
}

TEST(RunCage, is_closed_and_its_report_tells_by_what) {
  Problem problem = filling(tube(8, 4));
  const Result<RunCage> cage = run_cage(problem);
  ASSERT_TRUE(cage.ok()) << cage.error().message;
  EXPECT_TRUE(cage->report.boundaries.empty());
  EXPECT_EQ(cage->report.faces, static_cast<int>(cage->cage.faces.size()));
  ASSERT_EQ(cage->report.notes.size(), 3u);
  EXPECT_EQ(cage->report.notes[0], "filled boundary 1 of 8 vertices with 12 faces, the group 'fill-1'");
  EXPECT_EQ(cage->report.notes[2],
            "held is what is not filled and touches no filled boundary: all but the groups fill-1, fill-1-rim, fill-2, "
            "fill-2-rim");
}

TEST(RunCage, that_is_refined_first_tells_why) {
  Problem problem = filling(tube(9, 4), {{2}, {}});
  const Result<RunCage> cage = run_cage(problem);
  ASSERT_TRUE(cage.ok()) << cage.error().message;
  EXPECT_NE(cage->report.notes[0].find("; the cage was refined once first, because boundary 2 has 9 vertices"),
            std::string::npos)
      << cage->report.notes[0];
  EXPECT_EQ(cage->report.boundaries.size(), 1u) << "the other stays";
}

/// The problem that a report tells asks the same again.
TEST(RunCage, writes_what_is_held_into_the_problem_which_then_asks_the_same) {
  Problem problem = filling(tube(8, 4));
  const RunCage once = *run_cage(problem);
  ASSERT_TRUE(problem.constraints.free);
  EXPECT_EQ(problem.constraints.free->groups,
            (std::vector<std::string>{"fill-1", "fill-1-rim", "fill-2", "fill-2-rim"}));
  problem.options.weights = *weights_of("bending");
  Problem read = *parse_problem(problem_text(problem));
  ASSERT_TRUE(read.fill);
  const RunCage again = *run_cage(read);
  EXPECT_EQ(again.cage.faces, once.cage.faces);
  EXPECT_EQ(again.constraints.free->groups, once.constraints.free->groups);
}

TEST(RunCage, holds_nothing_on_its_own_where_the_problem_says_what_is_held) {
  Problem problem = filling(tube(8, 4));
  problem.constraints.hold.emplace();
  EXPECT_TRUE(run_cage(problem).ok());
  EXPECT_FALSE(problem.constraints.free);
}

/// A cage refined first has four quads for each of its faces: face 3 of the file has the numbers 9 to 12.
TEST(RunCage, finds_numbered_faces_and_pins_again_after_refinement) {
  Problem problem = filling(tube(9, 4));
  problem.constraints.hold = FaceSelection{{}, {3}};
  const auto pin = [](int face, double u, double v) {
    Pin result;
    result.face = face;
    result.uv = {u, v};
    return result;
  };
  Pin vertex;
  vertex.vertex = 12;
  problem.constraints.pins = {vertex, pin(2, 0.25, 0.125), pin(2, 0.75, 0.125), pin(2, 0.75, 1), pin(2, 0.25, 0.875)};
  const RunCage cage = *run_cage(problem);
  EXPECT_EQ(cage.constraints.hold->faces, (std::vector<int>{9, 10, 11, 12}));
  EXPECT_EQ(problem.constraints.hold->faces, std::vector<int>{3}) << "the problem keeps its own numbers";
  EXPECT_EQ(cage.constraints.pins[0].vertex, 12);
  const std::array<double, 2> expected[]{{0.5, 0.25}, {0.25, 0.5}, {0.5, 0}, {0.25, 0.5}};
  for (int corner = 0; corner < 4; ++corner) {
    EXPECT_EQ(cage.constraints.pins[corner + 1].face, 5 + corner);
    EXPECT_EQ(cage.constraints.pins[corner + 1].uv, expected[corner]) << corner;
  }
}

TEST(RunCage, finds_boundaries_again_that_stay) {
  Problem problem = filling(tube(8, 4), {{1}, {}});
  problem.constraints.boundary =
      BoundaryConditions{BoundaryCondition::kTangent, {{2, 33, 35, BoundaryCondition::kFree}}};
  EXPECT_EQ(run_cage(problem)->constraints.boundary->loops[0].loop, 1);
  EXPECT_EQ(run_cage(problem)->constraints.boundary->loops[0].from, 33);
  problem.constraints.boundary->loops[0].loop = 1;
  EXPECT_EQ(fill_error(problem), "t.obj: constraints.boundary.loops[0].loop: boundary 1 is filled");
}

TEST(RunCage, names_what_of_a_fill_does_not_fit) {
  EXPECT_EQ(fill_error(filling(tube(8, 4), {{1, 3}, {}})),
            "t.obj: fill.loops[1]: there is no boundary 3; the cage has 2");
  EXPECT_EQ(fill_error(filling(tube(8, 4), {{1, 1}, {}})), "t.obj: fill: boundary 1 is to be filled twice");
  EXPECT_EQ(fill_error(filling(tube(8, 4), {{}, {1, 9}})),
            "t.obj: fill.corners[1]: vertex 9 is on no boundary of the cage");
  EXPECT_EQ(fill_error(filling(tube(8, 4), {{1}, {33, 35, 37}})),
            "t.obj: fill: boundary 2 has marked corners, but is not filled");
  Problem closed{.cage = GeneratedCage{"cube", {}}, .fill = FillRequest{}};
  EXPECT_EQ(fill_error(closed), "fill: the cage is closed, and has no boundary to fill");
}

TEST(RunCage, refuses_to_hold_a_rest_that_has_no_surface_of_its_own) {
  EXPECT_NE(fill_error(filling(tube(8, 2))).find("every face of the cage touches a filled boundary"),
            std::string::npos);
  EXPECT_EQ(fill_error(filling(tube(8, 3))), "");
  Problem problem = filling(tube(8, 2));
  problem.constraints.free = FaceSelection{{"fill-1"}, {}};
  EXPECT_TRUE(run_cage(problem).ok()) << "unless it is told what to hold";
}

TEST(RunCage, takes_faces_for_holes_and_fills_them) {
  Problem problem = filling(tube(8, 6));
  problem.constraints.holes = FaceSelection{{}, {1, 2, 3, 4, 5, 6, 7, 8}};
  const RunCage cage = *run_cage(problem);
  Problem shorter = filling(tube(8, 5));
  EXPECT_EQ(cage.cage.faces.size(), run_cage(shorter)->cage.faces.size());
  problem.fill.reset();
  EXPECT_EQ(run_cage(problem)->cage.holes.size(), 8u) << "or leaves them open";
}

TEST(RunCage, lists_the_boundaries_of_its_surface_not_those_of_its_holes) {
  Problem problem{.cage = CageText{"t.obj", tube(8, 6)}};
  problem.constraints.holes = FaceSelection{{}, {1, 2, 3, 4, 5, 6, 7, 8}};
  const Result<CheckedCage> cage = cage_with_holes(problem);
  ASSERT_TRUE(cage.ok()) << cage.error().message;
  EXPECT_EQ(cage->report.holes, 8);
  EXPECT_EQ(cage->report.faces, 40);
  EXPECT_EQ(cage->report.vertices, 48);
  ASSERT_EQ(cage->report.boundaries.size(), 2u);
  EXPECT_EQ(cage->report.boundaries[0].first_vertex, 9);
  EXPECT_EQ(cage->report.boundaries[1].first_vertex, 49);
  // A ring in the middle parts the surface.
  problem.constraints.holes->faces = {17, 18, 19, 20, 21, 22, 23, 24};
  const CageReport parted = cage_with_holes(problem)->report;
  EXPECT_EQ(parted.components.size(), 2u);
  EXPECT_EQ(parted.boundaries.size(), 4u);
  EXPECT_EQ(parted.genus, 0);
}

TEST(RunCage, refuses_holes_that_meet_at_a_vertex_only_or_are_everything) {
  Problem problem{.cage = CageText{"t.obj", tube(8, 6)}};
  problem.constraints.holes = FaceSelection{{}, {9, 18}};
  EXPECT_EQ(fill_error(problem), "t.obj: vertex 18 joins 2 fans of faces with holes between them: not a manifold");
  problem.constraints.holes->faces.clear();
  for (int f = 1; f <= 48; ++f) problem.constraints.holes->faces.push_back(f);
  EXPECT_EQ(fill_error(problem), "t.obj: constraints.holes: all faces are holes");
}

}  // namespace
}  // namespace umbilic
