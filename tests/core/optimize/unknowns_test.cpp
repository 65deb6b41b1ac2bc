// SPDX-License-Identifier: MIT
/// \file
/// Unknowns of a coarser mesh: subdivided to the evaluated one, with the gradients and matrices that belong to them.
#include "optimize/unknowns.h"

#include <gtest/gtest.h>

#include "cage/generate.h"
#include "energy/surface_energy.h"
#include "linear_algebra.h"
#include "mesh/rough_cages.h"
#include "optimize/dense_assembly.h"
#include "optimize/hessian_assembly.h"

namespace umbilic::test {
namespace {

Cage hub_cage() { return *generate_cage("two-3", {.family = FrameFamily::kHub}); }

/// A cage that two steps make evaluable, with all coordinates or the symmetric ones.
struct Coarse {
  Cage cage = hub_cage();
  PolygonMesh mesh{cage};
  Refined fine = refined(cage, 2);
  SymmetryGroup group, fine_group;
  Coordinates coordinates, fine_coordinates;
  PatchLayout layout;
  Unknowns unknowns;

  explicit Coarse(bool symmetric)
      : group(symmetric ? find_symmetry(mesh, cage.vertices) : SymmetryGroup{}),
        fine_group(umbilic::refined(umbilic::refined(group, mesh), catmull_clark(mesh).mesh)),
        coordinates(mesh, group),
        fine_coordinates(fine.mesh, fine_group),
        layout(fine.mesh, CapKind::kSmooth, face_orbits(fine.mesh, fine_group)),
        unknowns(fine_coordinates, coordinates, stencil()) {}

 private:
  Eigen::SparseMatrix<double> stencil() const {
    const Refinement once = catmull_clark(mesh), twice = catmull_clark(once.mesh);
    return Eigen::SparseMatrix<double>(twice.stencil) * Eigen::SparseMatrix<double>(once.stencil);
  }
};

/// Coordinates near the cage's.
Eigen::VectorXd near(const Coarse& c) {
  const Eigen::VectorXd y = c.coordinates.unknowns(c.cage.vertices);
  return y + 0.05 * Random(4).matrix<Eigen::VectorXd>(y.size(), 1);
}

class UnknownsOfACoarserMesh : public testing::TestWithParam<bool> {};

TEST_P(UnknownsOfACoarserMesh, are_subdivided) {
  const Coarse c(GetParam());
  EXPECT_TRUE(c.unknowns.mapped());
  EXPECT_EQ(c.unknowns.count(), c.coordinates.count());
  const Eigen::VectorXd y = near(c);
  const Points expected = refined(c.mesh, c.coordinates.control(y), 2).control;
  EXPECT_LT((c.unknowns.control(y) - expected).cwiseAbs().maxCoeff(), 1e-14 * expected.norm());
}

TEST_P(UnknownsOfACoarserMesh, pull_gradients_back_by_the_transpose) {
  const Coarse c(GetParam());
  const Eigen::VectorXd y = near(c), zero = Eigen::VectorXd::Zero(y.size());
  const Points gradient = Random(5).points(c.fine.control.rows());
  const double forward = (c.unknowns.control(y) - c.unknowns.control(zero)).cwiseProduct(gradient).sum();
  EXPECT_NEAR(forward, y.dot(c.unknowns.pull_back(gradient)), 1e-13 * y.norm() * gradient.norm());
}

TEST_P(UnknownsOfACoarserMesh, have_the_gradients_that_differences_of_the_energy_give) {
  const Coarse c(GetParam());
  const JetEvaluator jets(c.layout, {4, 5, 1});
  for (const Weights& weights : {Weights{1, 0, 0, 0, 0, 0}, Weights{0, 0, 0, 1, 0, 0}}) {
    const SurfaceEnergy energy(jets, weights);
    const Eigen::VectorXd y = near(c), direction = Random(6).matrix<Eigen::VectorXd>(y.size(), 1);
    Points points_gradient;
    energy.evaluate(c.unknowns.control(y), &points_gradient);
    const Eigen::VectorXd gradient = c.unknowns.pull_back(points_gradient);
    const auto at = [&](double t) { return energy.evaluate(c.unknowns.control(y + t * direction), nullptr).energy; };
    const double h = 1e-4;
    const double difference = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    EXPECT_NEAR(gradient.dot(direction), difference, 1e-7 * gradient.norm() * direction.norm());
  }
}

TEST_P(UnknownsOfACoarserMesh, reduce_matrices_to_q_transposed_m_q) {
  const Coarse c(GetParam());
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(c.unknowns.count());
  const Eigen::VectorXd origin = c.fine_coordinates.unknowns(c.unknowns.control(zero));
  Eigen::MatrixXd q(c.fine_coordinates.count(), c.unknowns.count());
  for (int i = 0; i < c.unknowns.count(); ++i) {
    const Points moved = c.unknowns.control(Eigen::VectorXd::Unit(c.unknowns.count(), i));
    q.col(i) = c.fine_coordinates.unknowns(moved) - origin;
  }
  const Unknowns whole(c.fine_coordinates);
  HessianAssembly coarse(c.layout, c.unknowns, {0, 0, 0, 1, 0, 0}, {3, 3, 1}),
      reference(c.layout, whole, {0, 0, 0, 1, 0, 0}, {3, 3, 1});
  for (HessianAssembly* assembly : {&coarse, &reference}) {
    assembly->begin(c.unknowns.control(near(c)));
    while (!assembly->advance()) {
    }
  }
  for (const auto& [hessian, sobolev] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {1.0, 0.1}}) {
    const Eigen::SparseMatrix<double> lower = reference.combine(hessian, sobolev);
    const Eigen::MatrixXd matrix = full(lower), expected = congruent(matrix, q);
    EXPECT_LT((full(c.unknowns.reduce(lower)) - expected).norm(), 1e-13 * matrix.norm());
    EXPECT_LT((full(coarse.combine(hessian, sobolev)) - expected).norm(), 1e-13 * matrix.norm());
  }
  EXPECT_LT((coarse.factors() - q.transpose() * reference.factors()).norm(), 1e-13 * reference.factors().norm());
}

INSTANTIATE_TEST_SUITE_P(FreeAndSymmetric, UnknownsOfACoarserMesh, testing::Bool());

TEST(Unknowns, of_the_evaluated_mesh_are_its_coordinates) {
  const Unknowns unknowns{Coordinates(4)};
  EXPECT_FALSE(unknowns.mapped());
  EXPECT_EQ(unknowns.count(), 12);
  const Points points = Random(1).points(4);
  const Eigen::VectorXd y = points.reshaped<Eigen::RowMajor>();
  EXPECT_EQ(unknowns.control(y), points);
  EXPECT_EQ(unknowns.pull_back(points), y);
}

}  // namespace
}  // namespace umbilic::test
