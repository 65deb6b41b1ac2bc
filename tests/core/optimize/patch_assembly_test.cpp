// SPDX-License-Identifier: MIT
/// \file
/// Assembled Hessians against differences of the gradient, and assembly over symmetric and repeated points.
#include "optimize/patch_assembly.h"

#include <gtest/gtest.h>

#include <random>

#include "cage/generate.h"
#include "energy/energy_hessian.h"
#include "mesh/subdivision.h"

namespace umbilic {
namespace {

constexpr QuadratureRule kRule{4, 5, 1};

struct Fixture {
  PolygonMesh mesh;
  Points control;
};

Points random_points(int rows, int seed) {
  std::mt19937 random(seed);
  Points points(rows, 3);
  for (int i = 0; i < points.size(); ++i) points.data()[i] = 2.0 * random() / std::mt19937::max() - 1;
  return points;
}

/// Without symmetry, away from umbilics where curvatures are not smooth.
Fixture rough(std::string_view name, int level) {
  const Cage cage = *generate_cage(name);
  PolygonMesh mesh(cage);
  Points control = cage.vertices;
  for (int i = 0; i < level; ++i) {
    Refinement finer = catmull_clark(mesh);
    control = (finer.stencil * control).eval();
    mesh = std::move(finer.mesh);
  }
  control += 0.02 * random_points(static_cast<int>(control.rows()), 1);
  return {std::move(mesh), std::move(control)};
}

Eigen::VectorXd flat(const Points& points) { return Eigen::Map<const Eigen::VectorXd>(points.data(), points.size()); }

/// (sum of the patches' matrices + rank-two term) * direction.
Eigen::VectorXd hessian_times(const PatchLayout& layout, const Weights& weights, const Points& control,
                              const Eigen::VectorXd& direction) {
  const JetEvaluator jets(layout, kRule);
  const SurfaceEnergy energy(jets, weights);
  EnergyHessian hessian(layout, kRule, weights);
  hessian.move_to(control, energy.evaluate(control, nullptr));
  const PatchAssembly assembly(layout, Coordinates(layout.control_count()));
  PatchSums sums;
  assembly.clear(sums);
  for (int s = 0; s < static_cast<int>(layout.sets().size()); ++s) {
    for (int p = 0; p < layout.sets()[s].count(); ++p)
      assembly.add(s, p, hessian.patch(s, p), hessian.columns(s), sums);
  }
  assembly.eliminate(sums);
  const Eigen::SparseMatrix<double> lower = assembly.lower(sums.values);
  Eigen::VectorXd product = lower.selfadjointView<Eigen::Lower>() * direction;
  if (energy.third_order()) {
    Points third, area;
    energy.evaluate_factors(control, third, area);
    product += flat(area) * flat(third).dot(direction) + flat(third) * flat(area).dot(direction);
  }
  return product;
}

Eigen::VectorXd gradient_difference(const PatchLayout& layout, const Weights& weights, const Points& control,
                                    const Points& direction) {
  const JetEvaluator jets(layout, kRule);
  const SurfaceEnergy energy(jets, weights);
  // Fourth order, so that truncation and rounding are both near 1e-10.
  const double h = 1e-7;
  const auto gradient = [&](double t) {
    Points g;
    energy.evaluate(control + t * direction, &g);
    return flat(g);
  };
  return (8 * (gradient(h) - gradient(-h)) - (gradient(2 * h) - gradient(-2 * h))) / (12 * h);
}

void expect_derivative_of_gradient(const Fixture& surface, CapKind cap, const Weights& weights) {
  const PatchLayout layout(surface.mesh, cap);
  const Points direction = random_points(layout.control_count(), 2);
  const Eigen::VectorXd product = hessian_times(layout, weights, surface.control, flat(direction));
  const Eigen::VectorXd expected = gradient_difference(layout, weights, surface.control, direction);
  EXPECT_LT((product - expected).norm(), 1e-6 * expected.norm());
}

TEST(EnergyHessian, is_the_derivative_of_the_gradient_for_every_functional) {
  const Fixture surface = rough("two-3", 2);
  for (int f = 0; f < kFunctionalCount; ++f) {
    SCOPED_TRACE(kFunctionalNames[f]);
    Weights weights{};
    weights[f] = 1.3;
    expect_derivative_of_gradient(surface, CapKind::kSmooth, weights);
  }
}

TEST(EnergyHessian, is_the_derivative_of_the_gradient_for_blends_and_other_caps) {
  const Fixture coarse = rough("cube", 1);
  expect_derivative_of_gradient(coarse, CapKind::kSmooth, {0.5, 0.25, 0.1, 0.2, 0.3, 0.4});
  expect_derivative_of_gradient(coarse, CapKind::kNone, {1, 0.5, 0, 0, 0, 0});
}

}  // namespace
}  // namespace umbilic
