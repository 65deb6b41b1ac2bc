// SPDX-License-Identifier: MIT
/// \file
/// Matrices over symmetric coordinates, assembled from one patch of each orbit, against those of all points: B^T H B.
#include <gtest/gtest.h>

#include "cage/generate.h"
#include "linear_algebra.h"
#include "mesh/rough_cages.h"
#include "optimize/dense_assembly.h"
#include "optimize/hessian_assembly.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

struct Matrices {
  Eigen::MatrixXd hessian, sobolev, factors;
};

Matrices assembled(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights, const Points& control) {
  HessianAssembly assembly(layout, unknowns, weights, kFewPoints);
  assembly.begin(control);
  while (!assembly.advance()) {
  }
  return {full(assembly.combine(1, 0)), full(assembly.combine(0, 1)), assembly.factors()};
}

/// A symmetric surface away from its cage's special shape.
struct Symmetric {
  PolygonMesh mesh;
  SymmetryGroup group;
  Coordinates coordinates;
  Points control;

  Symmetric(const Cage& cage, int level) : mesh(cage), group(find_symmetry(mesh, cage.vertices)), coordinates(0) {
    const Refined finer = refined(cage, level);
    for (int i = 0; i < level; ++i) {
      group = umbilic::refined(group, mesh);
      mesh = catmull_clark(mesh).mesh;
    }
    coordinates = Coordinates(mesh, group);
    const Eigen::VectorXd y = coordinates.unknowns(finer.control);
    control = coordinates.control(y + 0.02 * Random(2).matrix<Eigen::VectorXd>(y.size(), 1));
  }
};

TEST(HessianAssembly, over_symmetric_coordinates_is_that_of_all_points_between_columns_of_b) {
  const Weights blend{0.5, 0.25, 0.001, 0.002, 0.001, 0.003, 0.002, 1e-5}, bending{1, 0, 0, 0, 0, 0};
  for (const char* name : {"cube", "torus", "two-3"}) {
    const Symmetric s(*generate_cage(name), 1);
    const Eigen::MatrixXd b(s.coordinates.matrix());
    for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat, CapKind::kNone}) {
      SCOPED_TRACE(std::string(name) + " cap " + std::to_string(static_cast<int>(cap)));
      const Weights& weights = cap == CapKind::kNone ? bending : blend;
      const PatchLayout whole(s.mesh, cap), orbits(s.mesh, cap, face_orbits(s.mesh, s.group));
      const Matrices all = assembled(whole, Unknowns(Coordinates(s.mesh.vertex_count())), weights, s.control);
      const Matrices reduced = assembled(orbits, Unknowns(s.coordinates), weights, s.control);
      const Eigen::MatrixXd hessian = congruent(all.hessian, b), sobolev = congruent(all.sobolev, b);
      // Of their entries, which near an extraordinary vertex are much larger than the sums.
      EXPECT_LT((reduced.hessian - hessian).norm(), 1e-11 * all.hessian.norm());
      EXPECT_LT((reduced.sobolev - sobolev).norm(), 1e-11 * all.sobolev.norm());
      EXPECT_LE((reduced.factors - b.transpose() * all.factors).norm(), 1e-11 * all.factors.norm());
    }
  }
}

TEST(HessianAssembly, has_no_factors_without_a_functional_of_third_order) {
  const Symmetric s(*generate_cage("cube"), 1);
  const PatchLayout layout(s.mesh, CapKind::kSmooth);
  const Unknowns unknowns{Coordinates(s.mesh.vertex_count())};
  EXPECT_EQ(assembled(layout, unknowns, {1, 2, 0, 0, 0, 0}, s.control).factors.cols(), 0);
  EXPECT_EQ(assembled(layout, unknowns, {1, 0, 0, 1, 0, 0}, s.control).factors.cols(), 2);
}

TEST(HessianAssembly, combines_linearly_and_progresses_from_0_to_1) {
  const Symmetric s(*generate_cage("two-3"), 2);
  const PatchLayout layout(s.mesh, CapKind::kSmooth);
  const Unknowns unknowns{Coordinates(s.mesh.vertex_count())};
  HessianAssembly assembly(layout, unknowns, {0, 0, 0, 1, 0, 0}, kFewPoints);
  assembly.begin(s.control);
  double progress = assembly.progress();
  EXPECT_EQ(progress, 0);
  int parts = 1;
  for (; !assembly.advance(); ++parts) {
    EXPECT_GE(assembly.progress(), progress);
    progress = assembly.progress();
  }
  EXPECT_EQ(assembly.progress(), 1);
  EXPECT_GT(parts, 10) << "no part is longer than an evaluation";
  const Eigen::SparseMatrix<double> sum = 2.0 * assembly.combine(1, 0) - 3.0 * assembly.combine(0, 1);
  EXPECT_LT((assembly.combine(2, -3) - sum).norm(), 1e-14 * sum.norm());
  assembly.begin(s.control);
  EXPECT_EQ(assembly.progress(), 0);
}

}  // namespace
}  // namespace umbilic::test
