// SPDX-License-Identifier: MIT
/// \file
/// Assembled Hessians against differences of the gradient, and assembly over symmetric and repeated points.
#include "optimize/patch_assembly.h"

#include <gtest/gtest.h>

#include "cage/generate.h"
#include "energy/energy_hessian.h"
#include "mesh/rough_cages.h"
#include "mesh/subdivision.h"

namespace umbilic::test {
namespace {

constexpr QuadratureRule kRule{4, 5, 1};

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
  HessianMemory memory;
  std::vector<double> block;
  PatchTerms terms;
  for (int s = 0; s < static_cast<int>(layout.sets().size()); ++s) {
    for (int p = 0; p < layout.sets()[s].count(); ++p) {
      hessian.patch(s, p, memory, block);
      assembly.terms(s, p, block.data(), hessian.columns(s), terms);
      assembly.add(s, p, terms, sums);
    }
  }
  assembly.eliminate(sums);
  const Eigen::SparseMatrix<double> lower = assembly.lower(sums.values);
  Eigen::VectorXd product = lower.selfadjointView<Eigen::Lower>() * direction;
  if (energy.third_order()) {
    Points slope, area;
    energy.evaluate_factors(control, slope, area);
    product += flat(area) * flat(slope).dot(direction) + flat(slope) * flat(area).dot(direction);
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

void expect_derivative_of_gradient(const Refined& surface, CapKind cap, const Weights& weights) {
  const PatchLayout layout(surface.mesh, cap);
  const Points direction = Random(2).points(layout.control_count());
  const Eigen::VectorXd product = hessian_times(layout, weights, surface.control, flat(direction));
  const Eigen::VectorXd expected = gradient_difference(layout, weights, surface.control, direction);
  EXPECT_LT((product - expected).norm(), 1e-6 * expected.norm());
}

TEST(EnergyHessianSlow, is_the_derivative_of_the_gradient_for_every_functional) {
  const Refined surface = rough(*generate_cage("two-3"), 2, 0.02, 1);
  for (int f = 0; f < kFunctionalCount; ++f) {
    SCOPED_TRACE(kFunctionalNames[f]);
    Weights weights{};
    weights[f] = 1.3;
    expect_derivative_of_gradient(surface, CapKind::kSmooth, weights);
  }
}

TEST(EnergyHessian, is_the_derivative_of_the_gradient_for_blends_and_other_caps) {
  const Refined coarse = rough(*generate_cage("cube"), 1, 0.02, 1);
  expect_derivative_of_gradient(coarse, CapKind::kSmooth, {0.5, 0.25, 0.1, 0.2, 0.3, 0.4, 0.5, 0.01});
  expect_derivative_of_gradient(coarse, CapKind::kNone, {1, 0.5, 0, 0, 0, 0});
}

}  // namespace
}  // namespace umbilic::test
