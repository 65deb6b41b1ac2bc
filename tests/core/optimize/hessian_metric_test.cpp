// SPDX-License-Identifier: MIT
/// \file
/// The Hessian as a metric: the inverse of a dense matrix on the directions that keep the size, positive definite
/// wherever it is built, and what the invariance of energies says about the Hessian in it.
#include "optimize/hessian_metric.h"

#include <gtest/gtest.h>

#include "cage/generate.h"
#include "energy/single_weight.h"
#include "linear_algebra.h"
#include "mesh/rough_cages.h"
#include "optimize/dense_assembly.h"
#include "optimize/metric_rules.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

constexpr CapKind kCap = CapKind::kSmooth;

template <class Parts>
void finish(Parts& parts, const Points& control) {
  parts.begin(control);
  while (!parts.advance()) {
  }
}

/// H + u v^T + v u^T + mu S.
Eigen::MatrixXd dense(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                      const Points& control, double mu, double umbilic_eta = kUmbilicEta) {
  HessianAssembly assembly(layout, unknowns, weights, kFewPoints, umbilic_eta);
  finish(assembly, control);
  Eigen::MatrixXd matrix = full(assembly.combine(1, mu));
  if (assembly.factors().cols() == 2) {
    const Eigen::VectorXd u = assembly.factors().col(0), v = assembly.factors().col(1);
    matrix += u * v.transpose() + v * u.transpose();
  }
  return matrix;
}

/// H + mu S as the metric has it.
Eigen::MatrixXd factored(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                         const Points& control, double mu) {
  HessianAssembly assembly(layout, unknowns, weights, kFewPoints, kMetricUmbilicEta);
  finish(assembly, control);
  return full(assembly.combine(1, mu));
}

/// A surface without symmetry, all coordinates free or those of its symmetric neighbours.
struct Surface {
  PolygonMesh mesh;
  Points control;
  PatchLayout layout;
  Unknowns unknowns;
};

Surface rough_surface(const Cage& cage, int level, double amount, unsigned seed) {
  const Refined r = rough(cage, level, amount, seed);
  return {r.mesh, r.control, PatchLayout(r.mesh, kCap), Unknowns(Coordinates(r.mesh.vertex_count()))};
}

Surface symmetric_surface(const Cage& cage) {
  const PolygonMesh coarse(cage);
  const SymmetryGroup group = umbilic::refined(find_symmetry(coarse, cage.vertices), coarse);
  const Refined r = refined(cage, 1);
  const PatchLayout layout(r.mesh, kCap, face_orbits(r.mesh, group));
  return {r.mesh, r.control, layout, Unknowns(Coordinates(r.mesh, group))};
}

TEST(HessianMetric, solve_inverts_hessian_plus_rank_two_term_plus_mu_sobolev_on_directions_that_keep_the_size) {
  for (const Surface& s :
       {rough_surface(cube(), 1, 0.05, 1), symmetric_surface(*generate_cage("two-3")),
        rough_surface(*generate_cage("torus", {.major_segments = 4, .minor_segments = 3}), 0, .05, 2)}) {
    for (const Weights& weights : {only(kBending), only(kMvsCross), Weights{1, 0, 0, 0.01, 0, 0}}) {
      HessianMetric metric(s.layout, s.unknowns, weights, kFewPoints);
      finish(metric, s.control);
      const Eigen::MatrixXd matrix =
          dense(s.layout, s.unknowns, weights, s.control, metric.sobolev_share(), kMetricUmbilicEta);
      const Eigen::VectorXd a = metric.size_gradient();
      const Eigen::MatrixXd q = orthogonal_complement(a);
      for (int i = 0; i < 5; ++i) {
        const Eigen::VectorXd g = Random(i).matrix<Eigen::VectorXd>(matrix.rows(), 1), d = metric.solve(g);
        // Condition numbers reach 1e6.
        EXPECT_LT(std::abs(a.dot(d)), 1e-8 * a.norm() * d.norm());
        EXPECT_LT((q.transpose() * (matrix * d - g)).norm(), 1e-8 * g.norm());
      }
    }
  }
}

TEST(HessianMetricSlow, is_positive_definite_from_every_rough_start_because_mu_rises_until_it_is) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    for (const double amount : {0.02, 0.2, 0.5}) {
      const Surface s = rough_surface(trapezohedron(5), 1, amount, seed);
      for (const int functional : {int(kBending), int(kMvs), int(kMvsCross)}) {
        SCOPED_TRACE(std::string(kFunctionalNames[functional]) + " moved by " + std::to_string(amount));
        HessianMetric metric(s.layout, s.unknowns, only(functional), kFewPoints);
        finish(metric, s.control);
        const auto definite = [&](double mu) {
          const Eigen::MatrixXd matrix = factored(s.layout, s.unknowns, only(functional), s.control, mu);
          return positive_definite(matrix);
        };
        EXPECT_GE(metric.sobolev_share(), 0.99e-2);
        if (metric.sobolev_share() > 1.01e-2) {
          EXPECT_FALSE(definite(metric.sobolev_share() / 10)) << "mu " << metric.sobolev_share();
        }
        const Eigen::VectorXd g = Random(seed).matrix<Eigen::VectorXd>(s.unknowns.count(), 1);
        EXPECT_GT(g.dot(metric.solve(g)), 0);
        // Folded surfaces, with energies of 1e15, may have no such mu: then it is the identity.
        EXPECT_TRUE(definite(metric.sobolev_share()) || metric.solve(g) == g) << "mu " << metric.sobolev_share();
      }
    }
  }
}

TEST(HessianMetric, can_be_built_again_at_other_surfaces_as_if_it_were_new_but_for_a_falling_mu) {
  const Surface a = rough_surface(trapezohedron(5), 1, 0.5, 1), b = rough_surface(trapezohedron(5), 1, 0.02, 2);
  const Weights weights = only(kMvsCross);
  HessianMetric metric(a.layout, a.unknowns, weights, kFewPoints);
  finish(metric, a.control);
  const double first = metric.sobolev_share();
  finish(metric, b.control);
  const double second = metric.sobolev_share();
  EXPECT_GE(second, 0.0999 * first);
  const Eigen::MatrixXd matrix = dense(b.layout, b.unknowns, weights, b.control, second, kMetricUmbilicEta);
  const Eigen::MatrixXd q = orthogonal_complement(metric.size_gradient());
  const Eigen::VectorXd x = q * Random(9).matrix<Eigen::VectorXd>(matrix.rows() - 1, 1);
  EXPECT_LT((metric.solve(matrix * x) - x).norm(), 1e-8 * x.norm());
  // It falls as far as the matrix stays positive definite.
  for (int i = 0; i < 3; ++i) finish(metric, b.control);
  EXPECT_LE(metric.sobolev_share(), second * 1.001);
  EXPECT_GE(metric.sobolev_share(), 0.99e-8);
}

TEST(HessianMetric, settles_with_the_matrices_that_it_has_and_with_a_mu_that_is_small_or_cannot_fall) {
  const Surface s = symmetric_surface(*generate_cage("two-3"));
  HessianMetric metric(s.layout, s.unknowns, only(kBending), kFewPoints);
  finish(metric, s.control);
  finish(metric, s.control);
  const double before = metric.sobolev_share();
  metric.settle();
  while (!metric.advance()) {
  }
  EXPECT_TRUE(metric.settled());
  const double mu = metric.sobolev_share();
  EXPECT_LE(mu, before * 1.001);
  const Eigen::MatrixXd smaller = factored(s.layout, s.unknowns, only(kBending), s.control, mu / 10);
  EXPECT_TRUE(mu <= 1.001e-5 || !positive_definite(smaller));
  const Eigen::MatrixXd matrix = dense(s.layout, s.unknowns, only(kBending), s.control, mu, kMetricUmbilicEta);
  const Eigen::MatrixXd q = orthogonal_complement(metric.size_gradient());
  const Eigen::VectorXd x = q * Random(9).matrix<Eigen::VectorXd>(matrix.rows() - 1, 1);
  EXPECT_LT((metric.solve(matrix * x) - x).norm(), 1e-8 * x.norm());
}

TEST(HessianMetric, predicts_decreases_unless_the_sobolev_product_outweighs_the_hessian) {
  // At surfaces so rough that mu is 10 or more, and once it has fallen on a smooth one.
  const Surface rough = rough_surface(trapezohedron(5), 1, 0.5, 1), smooth = rough_surface(trapezohedron(5), 1, 0, 1);
  HessianMetric metric(rough.layout, rough.unknowns, only(kMvsCross), kFewPoints);
  finish(metric, rough.control);
  ASSERT_GE(metric.sobolev_share(), kUninformativeMu);
  EXPECT_FALSE(metric.predicts());
  for (int i = 0; i < 6; ++i) finish(metric, smooth.control);
  ASSERT_LT(metric.sobolev_share(), kUninformativeMu);
  EXPECT_TRUE(metric.predicts());
}

/// Along x itself a Newton step gains nothing: with a . d = 0 it is one of the shape.
TEST(HessianMetric, moves_along_no_mere_change_of_scale) {
  const Surface s = symmetric_surface(*generate_cage("two-3"));
  const JetEvaluator jets(s.layout, kFewPoints);
  for (const int functional : {int(kBending), int(kMvsCross)}) {
    const Eigen::VectorXd x = s.unknowns.pull_back(s.control.rowwise() - s.control.colwise().mean());
    HessianMetric metric(s.layout, s.unknowns, only(functional), kFewPoints);
    finish(metric, s.control);
    EXPECT_GT(std::abs(metric.size_gradient().dot(x)), 1e-3 * metric.size_gradient().norm() * x.norm());
    EXPECT_LT(metric.solve(metric.size_gradient()).norm(), 1e-9 * x.norm()) << "no step answers a gradient of the size";
  }
}

TEST(HessianMetric, of_newton_is_positive_definite_with_a_smaller_mu_although_some_eigenvalues_are_negative) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Surface s = rough_surface(*generate_cage("cube"), 1, 0.03, seed);
    HessianMetric hessian(s.layout, s.unknowns, only(kMvsCross), kFewPoints);
    HessianMetric newton(s.layout, s.unknowns, only(kMvsCross), kFewPoints, {}, {}, nullptr, true);
    finish(hessian, s.control);
    finish(newton, s.control);
    const double mu = newton.sobolev_share();
    EXPECT_LT(mu, 0.11 * hessian.sobolev_share());
    const Eigen::VectorXd values = eigenvalues(factored(s.layout, s.unknowns, only(kMvsCross), s.control, mu));
    EXPECT_LT(values[0], 0);
    EXPECT_GT(values[kMostNegative], 0) << "no more of them than are replaced";
    const Eigen::VectorXd a = newton.size_gradient();
    for (int i = 0; i < 20; ++i) {
      const Eigen::VectorXd g = Random(100 * seed + i).matrix<Eigen::VectorXd>(s.unknowns.count(), 1);
      EXPECT_GT(g.dot(newton.solve(g)), 0);
      EXPECT_LT(std::abs(a.dot(newton.solve(g))), 1e-8 * a.norm() * newton.solve(g).norm());
    }
  }
}

TEST(HessianMetric, of_newton_trusts_itself_by_the_decreases_that_it_predicts) {
  const Surface s = rough_surface(cube(), 1, 0.05, 1);
  HessianMetric metric(s.layout, s.unknowns, only(kBending), kFewPoints, {}, {}, nullptr, true);
  const auto share_after = [&](double part) {
    metric.gained(part);
    finish(metric, s.control);
    return metric.sobolev_share();
  };
  const double first = share_after(1);
  EXPECT_NEAR(share_after(1), first / kMuFactor, 1e-9 * first);
  EXPECT_NEAR(share_after((kGoodGain + kPoorGain) / 2), first / kMuFactor, 1e-9 * first);
  EXPECT_NEAR(share_after(0.9 * kPoorGain), first * kMuRise / kMuFactor, 1e-9 * first);
}

TEST(HessianMetric, knows_the_hessian) {
  const Surface s = rough_surface(cube(), 1, 0.05, 1);
  const HessianMetric metric(s.layout, s.unknowns, only(kBending), kFewPoints);
  EXPECT_TRUE(metric.knows_hessian());
}

/// Energies have degree 0 in the control points, gradients -1: Euler's theorem. At a minimizer the scale is free.
TEST(HessianAssembly, with_its_rank_two_term_maps_the_control_points_to_minus_the_gradient) {
  const Surface s = rough_surface(*generate_cage("two-3"), 1, 0.05, 3);
  const JetEvaluator jets(s.layout, kFewPoints);
  for (int f = 0; f < kFunctionalCount; ++f) {
    Points gradient;
    SurfaceEnergy(jets, only(f)).evaluate(s.control, &gradient);
    const Eigen::MatrixXd matrix = dense(s.layout, s.unknowns, only(f), s.control, 0);
    const Eigen::VectorXd x = s.control.reshaped<Eigen::RowMajor>(), g = gradient.reshaped<Eigen::RowMajor>();
    EXPECT_LT((matrix * x + g).norm(), 1e-9 * g.norm()) << kFunctionalNames[f];
  }
}

TEST(HessianAssembly, maps_translations_to_zero_and_rotations_to_the_turned_gradient) {
  const Surface s = rough_surface(*generate_cage("two-3"), 1, 0.05, 3);
  const JetEvaluator jets(s.layout, kFewPoints);
  for (const int f : {int(kBending), int(kMvsCross)}) {
    Points gradient;
    SurfaceEnergy(jets, only(f)).evaluate(s.control, &gradient);
    const Eigen::MatrixXd matrix = dense(s.layout, s.unknowns, only(f), s.control, 0);
    for (int axis = 0; axis < 3; ++axis) {
      Points shift = Points::Zero(s.control.rows(), 3), turn = shift, turned = shift;
      shift.col(axis).setOnes();
      for (Eigen::Index v = 0; v < turn.rows(); ++v) {
        turn.row(v) = Vector3::Unit(axis).cross(Vector3(s.control.row(v))).transpose();
        turned.row(v) = Vector3::Unit(axis).cross(Vector3(gradient.row(v))).transpose();
      }
      EXPECT_LT((matrix * shift.reshaped<Eigen::RowMajor>()).norm(), 1e-9 * matrix.norm());
      EXPECT_LT((matrix * turn.reshaped<Eigen::RowMajor>() - turned.reshaped<Eigen::RowMajor>()).norm(),
                1e-9 * gradient.norm());
    }
  }
}

}  // namespace
}  // namespace umbilic::test
