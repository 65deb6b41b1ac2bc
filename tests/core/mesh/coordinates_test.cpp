// SPDX-License-Identifier: MIT
/// \file
/// Coordinates of symmetric points: orthonormal, invariant, and as many as characters say.
#include "mesh/coordinates.h"

#include <gtest/gtest.h>

#include "mesh/group_elements.h"
#include "mesh/symmetric_cages.h"

namespace umbilic::test {
namespace {

struct Symmetric {
  PolygonMesh mesh;
  Points points;
  SymmetryGroup group;
  Coordinates coordinates;

  explicit Symmetric(const Cage& cage)
      : mesh(cage), points(cage.vertices), group(find_symmetry(mesh, points)), coordinates(mesh, group) {}
};

const std::vector<Symmetric>& symmetric_cages() {
  static const std::vector<Symmetric> cages = [] {
    std::vector<Symmetric> result;
    for (const Cage& cage : {cube(), prism(5), trapezohedron(7), generate_cage("torus").value()}) {
      result.emplace_back(cage);
    }
    for (const PointGroup& group : point_groups()) {
      result.emplace_back(transformed(cage_with(group), some_rotation(), {1, 2, 3}));
    }
    return result;
  }();
  return cages;
}

Eigen::VectorXd random_unknowns(const Coordinates& coordinates) {
  return Random(8).matrix<Eigen::VectorXd>(coordinates.count(), 1);
}

Eigen::MatrixXd matrix_of(const Coordinates& coordinates) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(3 * coordinates.vertex_count(), coordinates.count());
  for (int v = 0; v < coordinates.vertex_count(); ++v) {
    const Coordinates::Block block = coordinates.block(v);
    b.block(3 * v, block.first, 3, block.dimension) = block.basis;
  }
  return b;
}

TEST(Coordinates, the_columns_are_orthonormal) {
  for (const Symmetric& s : symmetric_cages()) {
    const Eigen::MatrixXd b = matrix_of(s.coordinates), gram = b.transpose() * b;
    EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.rows())).cwiseAbs().maxCoeff(), 4e-15)
        << s.group.name;
  }
}

TEST(Coordinates, the_points_are_offset_plus_matrix_times_unknowns_and_gradients_its_transpose) {
  for (const Symmetric& s : symmetric_cages()) {
    const Eigen::MatrixXd b = matrix_of(s.coordinates);
    const Eigen::VectorXd y = random_unknowns(s.coordinates);
    const Points control = s.coordinates.control(y), offset = s.coordinates.control(Eigen::VectorXd::Zero(y.size()));
    const Eigen::VectorXd by = b * y;
    const Points linear = Eigen::Map<const Points>(by.data(), control.rows(), 3);
    EXPECT_LT((control - offset - linear).norm(), 1e-13);
    const Points gradient = Random(2).points(control.rows());
    const Eigen::VectorXd pulled = s.coordinates.pull_back(gradient);
    EXPECT_LT((pulled - b.transpose() * Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size())).norm(),
              1e-13);
    // <B y, g> = <y, B^T g>
    EXPECT_NEAR((control - offset).cwiseProduct(gradient).sum(), y.dot(pulled), 1e-12);
    EXPECT_LT((s.coordinates.unknowns(control) - y).norm(), 1e-13);
  }
}

TEST(Coordinates, symmetric_points_come_back_to_rounding) {
  for (const Symmetric& s : symmetric_cages()) {
    const Points back = s.coordinates.control(s.coordinates.unknowns(s.points));
    EXPECT_LT((back - s.points).rowwise().norm().maxCoeff(), 1e-14) << s.group.name;  // extent 2, at distance 4
  }
}

TEST(Coordinates, any_unknowns_give_points_that_every_generator_keeps) {
  for (const Symmetric& s : symmetric_cages()) {
    const Points control = s.coordinates.control(random_unknowns(s.coordinates));
    for (const Symmetry& generator : s.group.generators) {
      EXPECT_LT(error_of(s.mesh, control, s.group.center, generator), 1e-14) << s.group.name;
    }
  }
}

TEST(Coordinates, any_unknowns_give_points_of_at_least_that_symmetry_and_as_a_rule_no_more) {
  for (const PointGroup& group : point_groups()) {
    const Symmetric s(cage_with(group));
    const Eigen::VectorXd y = s.coordinates.unknowns(s.points);
    const Points moved = s.coordinates.control(y + 0.1 * random_unknowns(s.coordinates));
    EXPECT_EQ(find_symmetry(s.mesh, moved).name, group.name);
  }
}

TEST(Coordinates, there_are_as_many_unknowns_as_the_trace_formula_says) {
  // The dimension of the symmetric points is the mean over the group of trace(R_g) for each vertex that g keeps.
  for (const Symmetric& s : symmetric_cages()) {
    double traces = 0;
    for (const Symmetry& g : all_elements(s.group, s.mesh)) {
      for (int v = 0; v < s.mesh.vertex_count(); ++v) {
        if (image_of_vertex(s.mesh, g.map, v) == v) traces += g.isometry.trace();
      }
    }
    EXPECT_NEAR(traces / s.group.order, s.coordinates.count(), 1e-9) << s.group.name;
  }
}

TEST(Coordinates, the_corners_of_a_cube_have_one_unknown_and_its_refinements_1_per_orbit_and_degree_of_freedom) {
  const Symmetric s(cube());
  EXPECT_EQ(s.coordinates.count(), 1);
  const SymmetryGroup once = refined(s.group, s.mesh);
  const PolygonMesh mesh = catmull_clark(s.mesh).mesh;
  EXPECT_EQ(Coordinates(mesh, once).count(), 3) << "corner, edge and face points on axes";
  // The 48 edges and 24 quads of the first refinement give three further orbits, each point in a mirror.
  EXPECT_EQ(Coordinates(catmull_clark(mesh).mesh, refined(once, mesh)).count(), 9);
}

TEST(Coordinates, the_projection_is_orthogonal) {
  // What it takes away is orthogonal to every symmetric displacement.
  for (const Symmetric& s : symmetric_cages()) {
    const Points p = Random(6).points(s.mesh.vertex_count());
    const Points residual = p - s.coordinates.control(s.coordinates.unknowns(p));
    EXPECT_LT(s.coordinates.pull_back(residual).norm(), 1e-13);
  }
}

TEST(Coordinates, the_mean_over_the_group_is_the_projection) {
  for (const Symmetric& s : symmetric_cages()) {
    const Points p = Random(6).points(s.mesh.vertex_count());
    Points mean = Points::Zero(p.rows(), 3);
    const std::vector<Symmetry> elements = all_elements(s.group, s.mesh);
    for (const Symmetry& g : elements) {
      for (int v = 0; v < s.mesh.vertex_count(); ++v) {
        const Vector3 from = p.row(v).transpose() - s.group.center;
        mean.row(image_of_vertex(s.mesh, g.map, v)) += (s.group.center + g.isometry * from).transpose();
      }
    }
    mean /= static_cast<double>(elements.size());
    EXPECT_LT((mean - s.coordinates.control(s.coordinates.unknowns(p))).norm(), 1e-12) << s.group.name;
  }
}

TEST(Coordinates, without_symmetry_they_are_the_coordinates) {
  const Points p = Random(1).points(5);
  const Coordinates coordinates(5);
  EXPECT_EQ(coordinates.count(), 15);
  const Eigen::VectorXd y = coordinates.unknowns(p);
  EXPECT_EQ(y[3], p(1, 0));
  EXPECT_EQ(coordinates.control(y), p);
  EXPECT_EQ(coordinates.pull_back(p), y);
  EXPECT_EQ(coordinates.block(2).first, 6);
  EXPECT_EQ(matrix_of(coordinates), Eigen::MatrixXd::Identity(15, 15));
}

TEST(Coordinates, a_vertex_at_the_center_has_no_unknowns) {
  // A cube around a tetrahedron whose four vertices are one point.
  Cage point = tetrahedron();
  point.vertices.setZero();
  const Symmetric s(together({cube(), transformed(tetrahedron(), 0.5 * Matrix3::Identity())}));
  EXPECT_EQ(s.group.name, "Td");
  EXPECT_EQ(s.coordinates.count(), 3) << "two corners of the cube and one of the tetrahedron";
  SymmetryGroup inversion;
  inversion.generators.push_back({-Matrix3::Identity(), {false, {}}});
  for (int h = 0; h < 12; ++h) inversion.generators[0].map.halfedges.push_back(h);
  const Coordinates coordinates(PolygonMesh(point), inversion);
  EXPECT_EQ(coordinates.count(), 0);
  EXPECT_EQ(coordinates.control(Eigen::VectorXd(0)), Points::Zero(4, 3));
}

TEST(Coordinates, the_versions_in_place_give_the_same) {
  const Symmetric s(cage_with(point_groups()[7]));
  const Eigen::VectorXd y = random_unknowns(s.coordinates);
  Points control;
  Eigen::VectorXd unknowns, gradient;
  s.coordinates.control(y, control);
  s.coordinates.unknowns(control, unknowns);
  s.coordinates.pull_back(control, gradient);
  EXPECT_EQ(control, s.coordinates.control(y));
  EXPECT_EQ(unknowns, s.coordinates.unknowns(control));
  EXPECT_EQ(gradient, s.coordinates.pull_back(control));
}

TEST(Coordinates, are_determined_by_the_first_points_of_the_orbits) {
  for (const Symmetric& cage : symmetric_cages()) {
    const Points control = cage.coordinates.control(random_unknowns(cage.coordinates));
    const Points firsts = cage.coordinates.orbit_points(control);
    EXPECT_EQ(firsts.rows(), cage.coordinates.orbit_count());
    // Sums of three products of numbers of size 1.
    EXPECT_LT((cage.coordinates.control_from_orbits(firsts) - control).cwiseAbs().maxCoeff(), 1e-14) << cage.group.name;
    const Coordinates free(cage.mesh.vertex_count());
    EXPECT_EQ(free.control_from_orbits(free.orbit_points(control)), control);
  }
}

TEST(Coordinates, have_the_first_points_of_the_orbits_in_the_order_of_the_vertices) {
  for (const Symmetric& cage : symmetric_cages()) {
    const Points firsts = cage.coordinates.orbit_points(cage.points);
    std::vector<bool> seen(cage.mesh.vertex_count(), false);
    int orbit = 0;
    for (int v = 0; v < cage.mesh.vertex_count(); ++v) {
      if (seen[v]) continue;
      ASSERT_LT(orbit, firsts.rows());
      EXPECT_EQ(firsts.row(orbit++), cage.points.row(v));
      std::vector<int> reached{v};
      for (std::size_t i = 0; i < reached.size(); ++i) {
        if (seen[reached[i]]) continue;
        seen[reached[i]] = true;
        for (const Symmetry& g : cage.group.generators)
          reached.push_back(image_of_vertex(cage.mesh, g.map, reached[i]));
      }
    }
    EXPECT_EQ(orbit, firsts.rows());
  }
}

}  // namespace
}  // namespace umbilic::test
