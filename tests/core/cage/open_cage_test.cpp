// SPDX-License-Identifier: MIT
/// \file
/// Surfaces with boundary: their loops, their genus, their orientation, and what is still no surface.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "cage/boundary.h"
#include "cage/generate.h"
#include "cages.h"

namespace umbilic::test {
namespace {

using Loops = std::vector<std::vector<int>>;

std::string refusal_of(Cage cage) {
  const Result<CageReport> report = validate(cage);
  return report ? "" : report.error().message;
}

/// A strip of n quads whose ends meet: untwisted (open cylinder), or with half a twist (Moebius band).
Cage band(int n, bool twisted) {
  Cage cage;
  cage.vertices.resize(2 * n, 3);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159 * i / n;
    cage.vertices.row(2 * i) << std::cos(angle), std::sin(angle), 0;
    cage.vertices.row(2 * i + 1) << std::cos(angle), std::sin(angle), 1;
    const int next = 2 * ((i + 1) % n);
    const bool swap = twisted && i == n - 1;
    cage.faces.push_back({2 * i, next + (swap ? 1 : 0), next + (swap ? 0 : 1), 2 * i + 1});
  }
  return cage;
}

void reverse(std::vector<int>& face) { std::reverse(face.begin() + 1, face.end()); }

/// An n by n grid of squares in the plane z = 0, seen from above.
Cage square_grid(int n) {
  Cage cage;
  cage.vertices.resize((n + 1) * (n + 1), 3);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) cage.vertices.row(i * (n + 1) + j) << j, i, 0;
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int v = i * (n + 1) + j;
      cage.faces.push_back({v, v + 1, v + n + 2, v + n + 1});
    }
  }
  return cage;
}

/// Removes faces, none of which shares a vertex with another, at random until `most` are gone or none is left.
/// Returns how many have gone.
int punch(Cage& cage, int most, std::mt19937& random) {
  std::vector<std::vector<int>> faces = cage.faces;
  std::shuffle(faces.begin(), faces.end(), random);
  std::vector<bool> taken(cage.vertices.rows(), false);
  int gone = 0;
  for (const std::vector<int>& face : faces) {
    if (gone == most || std::any_of(face.begin(), face.end(), [&](int v) { return taken[v]; })) continue;
    for (const int v : face) taken[v] = true;
    cage.faces.erase(std::find(cage.faces.begin(), cage.faces.end(), face));
    ++gone;
  }
  return gone;
}

}  // namespace

TEST(OpenCage, a_single_polygon_is_a_disk_whose_loop_runs_as_the_polygon_does) {
  Cage cage = square_grid(1);
  const CageReport report = report_of(cage);
  EXPECT_EQ(report.genus, 0);
  ASSERT_EQ(report.boundaries.size(), 1u);
  EXPECT_EQ(report.boundaries[0].number, 1);
  EXPECT_EQ(report.boundaries[0].vertices, 4);
  EXPECT_EQ(report.boundaries[0].first_vertex, 1);
  EXPECT_EQ(report.boundaries[0].component, 1);
  EXPECT_EQ(boundary_loops(cage), (Loops{{0, 1, 3, 2}}));
  reverse(cage.faces[0]);
  EXPECT_EQ(boundary_loops(cage), (Loops{{0, 2, 3, 1}}));
}

TEST(OpenCage, a_disk_has_its_interior_to_the_left_of_its_loop) {
  const Cage cage = square_grid(5);
  const Loops loops = boundary_loops(cage);
  ASSERT_EQ(loops.size(), 1u);
  ASSERT_EQ(loops[0].size(), 20u);
  double twice_area = 0;  // positive for loops that run counterclockwise
  for (std::size_t i = 0; i < 20; ++i) {
    const auto a = cage.vertices.row(loops[0][i]), b = cage.vertices.row(loops[0][(i + 1) % 20]);
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_EQ(twice_area, 50);
}

TEST(OpenCage, a_cylinder_has_two_loops_that_run_against_each_other) {
  const Cage cage = band(4, false);
  EXPECT_EQ(boundary_loops(cage), (Loops{{0, 2, 4, 6}, {1, 7, 5, 3}}));
  const CageReport report = report_of(cage);
  EXPECT_EQ(report.genus, 0);
  EXPECT_EQ(report.edges, 12);
  ASSERT_EQ(report.components.size(), 1u);
  EXPECT_EQ(report.components[0].boundaries, 2);
  EXPECT_EQ(report.boundaries.at(1).number, 2);
  EXPECT_EQ(report.boundaries.at(1).first_vertex, 2);
}

TEST(OpenCage, a_closed_cage_has_no_loop) {
  for (const char* name : {"cube", "torus", "octahedron-frame"}) {
    EXPECT_TRUE(boundary_loops(generated(name)).empty());
    EXPECT_TRUE(report_of(generated(name)).boundaries.empty());
  }
}

TEST(OpenCage, holes_that_are_cut_into_a_surface_keep_its_genus_and_are_counted) {
  std::mt19937 random(3);
  for (const char* name : {"cube", "torus", "two-3", "tetrahedron-frame"}) {
    const Cage whole = generated(name);
    const int genus = report_of(whole).genus;
    for (int most = 1; most < 6; ++most) {
      Cage cage = whole;
      const int gone = punch(cage, most, random);
      const CageReport report = report_of(cage);
      EXPECT_EQ(report.genus, genus) << name;
      EXPECT_EQ(static_cast<int>(report.boundaries.size()), gone) << name;
      EXPECT_EQ(report.components.at(0).boundaries, gone) << name;
    }
  }
}

TEST(OpenCage, filling_each_loop_backwards_closes_the_surface_without_turning_a_face) {
  std::mt19937 random(9);
  for (const char* name : {"torus", "two-4", "cube-frame"}) {
    for (int most = 1; most < 6; ++most) {
      Cage cage = generated(name);
      const int genus = report_of(cage).genus;
      punch(cage, most, random);
      ASSERT_TRUE(validate(cage).ok());
      for (std::vector<int> loop : boundary_loops(cage)) {
        std::reverse(loop.begin(), loop.end());
        cage.faces.push_back(loop);
      }
      const CageReport filled = report_of(cage);
      EXPECT_EQ(filled.genus, genus);
      EXPECT_TRUE(filled.boundaries.empty());
      EXPECT_TRUE(filled.repairs.empty());
    }
  }
}

TEST(OpenCage, loops_do_not_depend_on_how_faces_are_ordered_and_follow_the_vertices_when_those_are) {
  std::mt19937 random(5);
  Cage cage = generated("torus");
  punch(cage, 4, random);
  const Loops loops = boundary_loops(cage);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<int> order(cage.vertices.rows());
    std::iota(order.begin(), order.end(), 0);
    if (trial >= 10) std::shuffle(order.begin(), order.end(), random);
    Cage other = cage;
    for (std::vector<int>& face : other.faces) {
      for (int& v : face) v = order[v];
      std::rotate(face.begin(), face.begin() + static_cast<long>(random() % face.size()), face.end());
    }
    std::shuffle(other.faces.begin(), other.faces.end(), random);
    Loops expected = loops;
    for (std::vector<int>& loop : expected) {
      for (int& v : loop) v = order[v];
      std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(boundary_loops(other), expected);
  }
}

TEST(OpenCage, loops_are_named_by_the_numbers_of_the_text_where_unused_vertices_were_dropped) {
  const CheckedCage read =
      read_checked_cage("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 1 1 0\nv 5 5 5\nv 6 5 5\nv 5 6 5\nf 6 7 8\nf 5 2 3\n")
          .value();
  ASSERT_EQ(read.report.boundaries.size(), 2u);
  EXPECT_EQ(read.report.boundaries[0].first_vertex, 2);
  EXPECT_EQ(read.report.boundaries[0].component, 2)
      << "components are in the order of faces, loops in that of vertices";
  EXPECT_EQ(read.report.boundaries[1].first_vertex, 6);
  EXPECT_EQ(read.report.boundaries[1].component, 1);
  EXPECT_EQ(boundary_loops(read.cage), (Loops{{0, 1, 2}, {3, 4, 5}}));
}

TEST(OpenCage, open_and_closed_components_stand_beside_each_other) {
  std::mt19937 random(2);
  Cage holed = generated("torus");
  punch(holed, 2, random);
  const CageReport report = report_of(together({band(5, false), generated("two-4"), holed, square_grid(2)}, 5));
  ASSERT_EQ(report.components.size(), 4u);
  const std::vector<std::pair<int, int>> genus_and_boundaries{{0, 2}, {3, 0}, {1, 2}, {0, 1}};
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(report.components[c].genus, genus_and_boundaries[c].first) << c;
    EXPECT_EQ(report.components[c].boundaries, genus_and_boundaries[c].second) << c;
  }
  EXPECT_EQ(report.genus, 4);
  ASSERT_EQ(report.boundaries.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(report.boundaries[i].number, static_cast<int>(i) + 1);
    EXPECT_EQ(report.boundaries[i].component, (std::vector{1, 1, 3, 3, 4})[i]);
  }
}

TEST(OpenCage, faces_that_agree_are_left_as_they_are_even_if_the_filled_surface_would_be_inside_out) {
  Cage cage = generated("cube");
  cage.faces.pop_back();
  Cage reversed = cage;
  for (std::vector<int>& face : reversed.faces) reverse(face);
  for (const Cage& given : {cage, reversed}) {
    Cage checked = given;
    const Result<CageReport> report = validate(checked);
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(checked.faces, given.faces);
    EXPECT_TRUE(report->repairs.empty());
  }
  Cage beside = together({reversed, generated("cube")}, 4);
  for (std::size_t f = 5; f < 11; ++f) reverse(beside.faces[f]);
  Cage checked = beside;
  const Result<CageReport> report = validate(checked);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->repairs, std::vector<std::string>{"turned 6 faces, so that what pointed inward points outward"});
  EXPECT_TRUE(std::equal(beside.faces.begin(), beside.faces.begin() + 5, checked.faces.begin()))
      << "the open one stays";
}

TEST(OpenCage, faces_that_disagree_are_turned_as_most_are_or_as_the_first_is) {
  const Cage whole = square_grid(3);
  for (std::size_t turned = 0; turned < 9; ++turned) {
    Cage cage = whole;
    reverse(cage.faces[turned]);
    const Result<CageReport> report = validate(cage);
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(cage.faces, whole.faces);
    EXPECT_EQ(report->repairs,
              std::vector<std::string>{"turned 1 face, so that all faces agree on one side as the outside"});
  }
  Cage two = band(6, false);
  for (std::size_t f = 0; f < 3; ++f) reverse(two.faces[f]);
  const std::vector<int> first = two.faces[0];
  ASSERT_TRUE(validate(two).ok());
  EXPECT_EQ(two.faces[0], first);
  EXPECT_EQ(report_of(two).boundaries.size(), 2u);
}

TEST(OpenCage, a_moebius_band_is_refused_however_its_faces_are_turned) {
  std::mt19937 random(1);
  for (const int n : {3, 4, 7}) {
    for (int trial = 0; trial < 5; ++trial) {
      Cage cage = band(n, true);
      for (std::vector<int>& face : cage.faces) {
        if (random() % 2) reverse(face);
      }
      EXPECT_NE(refusal_of(cage).find("cannot be turned to match all of its neighbours: the surface is not orientable"),
                std::string::npos);
    }
  }
}

TEST(OpenCage, two_boundary_fans_at_a_vertex_are_refused) {
  EXPECT_EQ(error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n"),
            "line 1: vertex 1 joins 2 separate fans of faces: not a manifold");
  Cage grid = square_grid(3);
  grid.faces.erase(grid.faces.begin() + 4);
  EXPECT_EQ(report_of(grid).boundaries.size(), 2u);
  grid.faces.erase(grid.faces.begin());
  EXPECT_EQ(refusal_of(grid), "vertex 6 joins 2 separate fans of faces: not a manifold")
      << "two holes meet in a corner";
}

TEST(OpenCage, a_boundary_fan_that_touches_an_interior_vertex_is_refused) {
  Cage cage = together({generated("cube"), square_grid(2)}, 3);
  identify(cage, 7, 8);
  EXPECT_EQ(refusal_of(cage), "vertex 8 joins 2 separate fans of faces: not a manifold");
}

TEST(OpenCage, three_pages_of_a_book_are_refused_at_their_back) {
  EXPECT_EQ(error_of("v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 2 1 4\n# third\nf 1 2 5\n"),
            "line 9: edge between vertices 1 and 2 belongs to 3 faces: not a manifold");
}

TEST(OpenCage, a_polygon_on_a_line_or_without_area_is_refused) {
  EXPECT_EQ(error_of("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
            "line 4: face 1 is part of no surface: all vertices of the cage lie on one line");
  EXPECT_EQ(error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 5 5 5\nv 5 5 5\nf 1 2 3\nf 4 5 6\n"),
            "line 8: face 2 is part of no surface: all vertices of the component of this face coincide");
}

TEST(OpenCage, a_seam_of_doubled_vertices_is_noted_as_a_likely_mistake) {
  const std::string seam = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 -1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 5 4 3\n";
  const CheckedCage read = read_checked_cage(seam).value();
  EXPECT_EQ(read.report.notes,
            std::vector<std::string>{"vertices 2 and 5 coincide, so merging duplicate vertices may close the surface"});
  EXPECT_TRUE(report_of(square_grid(2)).notes.empty());
}

}  // namespace umbilic::test
