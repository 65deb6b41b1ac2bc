// SPDX-License-Identifier: MIT
/// \file
/// What is a cage and what is not, beyond what a file's syntax can say.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "cage/generate.h"
#include "cages.h"

namespace umbilic::test {

namespace {

std::string error_of(Cage cage) {
  const Cage before = cage;
  const Result<CageReport> report = validate(cage);
  EXPECT_EQ(cage.faces, before.faces) << "an error leaves the cage alone";
  return report ? "" : report.error().message;
}

/// The grid torus with one pair of sides glued in reverse: closed, not orientable.
Cage klein_bottle(int n) {
  Cage cage;
  cage.vertices = Points::Random(n * n, 3);
  const auto at = [n](int i, int j) { return i < n ? i * n + j % n : (2 * n - j) % n; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) cage.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return cage;
}

}  // namespace

TEST(Validate, counts_satisfy_the_formula_of_euler) {
  const CageReport cube = report_of(generated("cube"));
  EXPECT_EQ(cube.vertices, 8);
  EXPECT_EQ(cube.edges, 12);
  EXPECT_EQ(cube.faces, 6);
  EXPECT_EQ(cube.genus, 0);
  ASSERT_EQ(cube.components.size(), 1u);
  EXPECT_EQ(cube.components[0].edges, 12);
}

TEST(Validate, components_are_counted_in_the_order_of_their_first_face) {
  const CageReport report = report_of(together({generated("torus"), generated("cube"), generated("two-4")}, 4));
  ASSERT_EQ(report.components.size(), 3u);
  EXPECT_EQ(report.components[0].genus, 1);
  EXPECT_EQ(report.components[1].genus, 0);
  EXPECT_EQ(report.components[1].vertices, 8);
  EXPECT_EQ(report.components[2].genus, 3);
  EXPECT_EQ(report.genus, 4);
  EXPECT_EQ(report.vertices, 48 + 8 + 28);
}

TEST(Validate, an_outward_cage_is_left_as_it_is_and_an_inward_one_is_turned) {
  const Cage outward = generated("tetrahedron-frame");
  Cage inward = outward;
  for (std::vector<int>& face : inward.faces) std::reverse(face.begin() + 1, face.end());
  report_of(outward);
  ASSERT_TRUE(validate(inward).ok());
  EXPECT_EQ(inward.faces, outward.faces);
}

TEST(Validate, faces_of_mixed_orientation_are_turned_to_enclose_positive_volume_in_each_component) {
  const Cage outward = together({generated("two-3"), generated("cube"), generated("torus")}, 5);
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    Cage mixed = outward;
    for (std::vector<int>& face : mixed.faces) {
      if (random() % 2) std::reverse(face.begin() + 1, face.end());
    }
    ASSERT_TRUE(validate(mixed).ok());
    EXPECT_EQ(mixed.faces, outward.faces);
  }
}

TEST(Validate, orientation_depends_neither_on_position_nor_on_size) {
  for (const double size : {1e-300, 1e-12, 1., 1e300}) {
    for (const double shift : {0., 1e6}) {
      Cage cage = generated("cube");
      const Cage outward = cage;
      cage.vertices = size * (cage.vertices.array() + shift);
      for (std::vector<int>& face : cage.faces) std::reverse(face.begin() + 1, face.end());
      ASSERT_TRUE(validate(cage).ok());
      EXPECT_EQ(cage.faces, outward.faces) << size << " " << shift;
    }
  }
}

TEST(Validate, a_far_unused_vertex_does_not_hide_the_orientation) {
  Cage cage = generated("cube");
  const Cage outward = cage;
  for (std::vector<int>& face : cage.faces) std::reverse(face.begin() + 1, face.end());
  cage.vertices.conservativeResize(9, 3);
  cage.vertices.row(8).setConstant(1e308);
  ASSERT_TRUE(validate(cage).ok());
  EXPECT_EQ(cage.faces, outward.faces);
  EXPECT_EQ(cage.vertices, outward.vertices);
}

TEST(Validate, the_result_does_not_depend_on_how_vertices_and_faces_are_numbered) {
  const Cage cage = generated("octahedron-frame");
  std::mt19937 random(11);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<int> order(cage.vertices.rows());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    Cage relabelled = cage;
    for (std::size_t v = 0; v < order.size(); ++v) {
      relabelled.vertices.row(order[v]) = cage.vertices.row(static_cast<Eigen::Index>(v));
    }
    for (std::vector<int>& face : relabelled.faces) {
      for (int& v : face) v = order[v];
      std::rotate(face.begin(), face.begin() + static_cast<long>(random() % face.size()), face.end());
    }
    std::shuffle(relabelled.faces.begin(), relabelled.faces.end(), random);
    const Cage before = relabelled;
    const Result<CageReport> report = validate(relabelled);
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(report->genus, 7);
    EXPECT_EQ(relabelled.faces, before.faces) << "it was outward already";
  }
}

TEST(Validate, vertices_that_no_face_uses_are_dropped) {
  const Cage cage = cage_of(
      "v 9 9 9\nv 1 1 1\nv 8 8 8\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nv 7 7 7\nf 2 4 5\nf 2 5 6\nf 2 6 4\nf 4 6 5\n");
  expect_tetrahedron(tetrahedron_obj());
  EXPECT_EQ(cage.vertices, cage_of(tetrahedron_obj()).vertices);
  EXPECT_EQ(cage.faces, cage_of(tetrahedron_obj()).faces);
}

TEST(Validate, a_klein_bottle_is_refused_as_not_orientable) {
  const std::string message = error_of(klein_bottle(5));
  EXPECT_NE(message.find("cannot be turned to match all of its neighbours: the surface is not orientable"),
            std::string::npos)
      << message;
}

TEST(Validate, an_edge_of_three_faces_is_refused) {
  EXPECT_EQ(umbilic::test::error_of(tetrahedron_obj() + "v 3 3 3\nf 1 2 5\n"),
            "line 10: edge between vertices 1 and 2 belongs to 3 faces: not a manifold");
}

TEST(Validate, two_bodies_that_share_an_edge_are_refused) {
  Cage cage = together({generated("cube"), generated("cube")}, 3);
  identify(cage, 1, 8);
  identify(cage, 2, 11);
  EXPECT_EQ(error_of(cage), "edge between vertices 2 and 3 belongs to 4 faces: not a manifold");
}

TEST(Validate, two_bodies_that_touch_in_a_vertex_are_refused) {
  Cage cage = together({generated("cube"), generated("cube")}, 3);
  identify(cage, 6, 8);
  EXPECT_EQ(error_of(cage), "vertex 7 joins 2 separate fans of faces: not a manifold");
}

TEST(Validate, a_body_that_touches_itself_in_a_vertex_is_refused) {
  Cage cage = generated("torus");
  identify(cage, 0, 27);
  EXPECT_EQ(error_of(cage), "vertex 1 joins 2 separate fans of faces: not a manifold");
}

TEST(Validate, the_same_face_three_times_is_refused_and_twice_is_a_closed_pillow) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(umbilic::test::error_of(triangle + "f 1 2 3\nf 1 2 3\nf 3 2 1\n"),
            "line 6: edge between vertices 1 and 2 belongs to 3 faces: not a manifold");
  const Cage pillow = cage_of(triangle + "f 1 2 3\nf 1 2 3\n");
  EXPECT_EQ(pillow.faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 1}})) << "no volume: the first face decides";
  EXPECT_EQ(report_of(pillow).genus, 0);
}

TEST(Validate, points_on_a_line_or_in_one_place_are_refused_wherever_they_are) {
  for (const double size : {1e-200, 1., 1e200}) {
    for (const double shift : {0., 1e9}) {
      Cage cage = generated("cube");
      cage.vertices = Points::Constant(8, 3, size * (1 + shift));
      EXPECT_EQ(error_of(cage), "face 1 is part of no surface: all vertices of the cage coincide");
      for (int v = 0; v < 8; ++v) cage.vertices.row(v) << v * size, (2 * v + shift) * size, (3 - v) * size;
      EXPECT_EQ(error_of(cage), "face 1 is part of no surface: all vertices of the cage lie on one line");
    }
  }
}

TEST(Validate, a_component_on_a_line_is_refused_by_its_first_face) {
  Cage cage = together({generated("torus"), generated("cube")}, 4);
  cage.vertices.bottomRows(8).rightCols(2).setZero();
  EXPECT_EQ(error_of(cage),
            "face 49 is part of no surface: all vertices of the component of this face lie on one line");
}

TEST(Validate, a_torus_whose_tube_has_no_radius_is_refused) {
  Cage cage = generated("torus");
  for (int v = 0; v < 48; ++v) cage.vertices.row(v) = cage.vertices.row(v / 8 * 8).eval();
  EXPECT_EQ(error_of(cage), "face 1 is part of no surface: all faces of the cage have zero area");
}

TEST(Validate, flat_cages_and_double_covers_are_cages) {
  Cage cage = generated("cube");
  cage.vertices.col(2).setZero();
  EXPECT_EQ(report_of(cage).genus, 0);
}

/// Two triangles and two faces without area: a tetrahedron in whose second and third vertices coincide.
Cage two_equal_points() {
  Cage cage = cage_of(tetrahedron_obj());
  cage.vertices << 0.5, 1, 1, 1, -1, -1, 1, -1, -1, -1.2, -1, 1;
  return cage;
}

TEST(Validate, where_there_is_no_volume_faces_that_agree_stay_as_they_are) {
  Cage double_cube = generated("cube");
  double_cube.vertices.col(0).setZero();
  for (Cage cage : {two_equal_points(), double_cube}) {
    for (const bool reversed : {false, true}) {
      for (const double shift : {0., 1e8}) {
        Cage given = cage;
        given.vertices.array() += shift;
        if (reversed) {
          for (std::vector<int>& face : given.faces) std::reverse(face.begin() + 1, face.end());
        }
        const std::vector<std::vector<int>> faces = given.faces;
        std::rotate(given.faces.begin(), given.faces.begin() + 1, given.faces.end());
        const Result<CageReport> report = validate(given);
        ASSERT_TRUE(report.ok());
        EXPECT_TRUE(report->repairs.empty());
        std::rotate(given.faces.begin(), given.faces.end() - 1, given.faces.end());
        EXPECT_EQ(given.faces, faces);
      }
    }
  }
}

TEST(Validate, where_there_is_no_volume_most_faces_stay_as_they_are_whichever_comes_first) {
  const Cage cage = two_equal_points();
  for (std::size_t wrong = 0; wrong < 4; ++wrong) {
    Cage mixed = cage;
    std::reverse(mixed.faces[wrong].begin() + 1, mixed.faces[wrong].end());
    const Result<CageReport> report = validate(mixed);
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(mixed.faces, cage.faces) << wrong;
    EXPECT_EQ(report->repairs,
              std::vector<std::string>{"turned 1 face, so that all faces agree on one side as the outside"});
  }
}

TEST(Validate, every_repair_is_said) {
  const Cage outward = generated("cube");
  EXPECT_TRUE(report_of(outward).repairs.empty());
  Cage cage = outward;
  for (std::vector<int>& face : cage.faces) std::reverse(face.begin() + 1, face.end());
  cage.vertices.conservativeResize(10, 3);
  cage.vertices.bottomRows(2).setOnes();
  EXPECT_EQ(report_of(cage).repairs,
            (std::vector<std::string>{"turned 6 faces, so that what pointed inward points outward",
                                      "dropped 2 vertices that no face uses"}));
  const std::string text = "v 9 9 9\nv 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 2 3 4\nf 2 4 5\nf 2 5 3\nf 3 5 4\n";
  EXPECT_EQ(read_checked_cage(text)->report.repairs, std::vector<std::string>{"dropped 1 vertex that no face uses"});
}

TEST(Validate, programs_hear_of_bad_indices_and_coordinates_too) {
  Cage cage = generated("cube");
  EXPECT_EQ(error_of(Cage{}), "the cage has no faces");
  cage.faces[2][1] = -1;
  EXPECT_EQ(error_of(cage), "face 3 names vertex 0, but there are 8 vertices");
  cage = generated("cube");
  cage.vertices(4, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(cage), "vertex 5 is not finite");
}

}  // namespace umbilic::test
