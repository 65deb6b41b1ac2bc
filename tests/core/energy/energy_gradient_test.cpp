// SPDX-License-Identifier: MIT
/// \file
/// Gradients by the control points against central differences, for every functional, cap, and perturbed cage.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "energy/surface_energy.h"
#include "mesh/rough_cages.h"
#include "reference/reference_cages.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

/// The least relative difference, over some steps, between the slope along `direction` and its central difference of
/// order
/// 4. Too long ones are inexact, third-order functionals of small patches first; too short ones lose digits.
template <class Energy>
double mismatch(const Energy& energy, const Points& control, const Points& gradient, const Points& direction) {
  const double slope = gradient.cwiseProduct(direction).sum();
  const double typical = gradient.norm() * direction.norm() / std::sqrt(static_cast<double>(gradient.size()));
  double least = std::numeric_limits<double>::infinity();
  for (const double h : {3e-4, 3e-5, 3e-6, 1e-6}) {
    const auto at = [&](double t) { return energy(control + t * direction); };
    const double quotient = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    least = std::min(least, std::abs(quotient - slope) / std::max(std::abs(slope), typical));
  }
  return least;
}

void expect_gradients(const std::string& name, int level, CapKind cap) {
  const Refined mesh = refined(reference_cage(name), level);
  const PatchLayout layout(mesh.mesh, cap);
  const JetEvaluator jets(layout, {3, 4, 2});
  std::vector<Weights> all;
  for (int f = 0; f < kFunctionalCount; ++f) {
    Weights single{};
    single[f] = 1;
    all.push_back(single);
  }
  all.push_back({0.3, 0.2, 1e-3, 2e-3, 1e-3, 3e-3, 2e-3, 1e-5});  // all powers of the area at once
  for (const Weights& weights : all) {
    const SurfaceEnergy energy(jets, weights);
    Points gradient;
    const EnergyValue value = energy.evaluate(mesh.control, &gradient);
    EXPECT_TRUE(std::isfinite(value.energy));
    EXPECT_EQ(value.energy, energy.evaluate(mesh.control, nullptr).energy) << "with or without gradient";
    Random random(12);
    for (int trial = 0; trial < 2; ++trial) {
      const Points direction = random.points(mesh.control.rows());
      const auto at = [&](const Points& control) { return energy.evaluate(control, nullptr).energy; };
      EXPECT_LT(mismatch(at, mesh.control, gradient, direction), 1e-7)
          << name << " cap " << static_cast<int>(cap) << " functional "
          << std::distance(weights.begin(), std::max_element(weights.begin(), weights.end()));
    }
  }
}

TEST(SurfaceEnergySlow, gradient_on_the_perturbed_torus_equals_central_differences) {
  expect_gradients("torus", 0, CapKind::kSmooth);
}

TEST(SurfaceEnergySlow, gradient_on_the_perturbed_cube_equals_central_differences_with_every_cap) {
  for (const CapKind cap : kAllCaps) expect_gradients("cube", 1, cap);  // smooth: one ring
  expect_gradients("cube", 2, CapKind::kSmooth);                        // two rings
}

TEST(SurfaceEnergySlow, gradient_on_the_perturbed_genus_2_cage_equals_central_differences_with_every_cap) {
  for (const CapKind cap : kAllCaps) expect_gradients("g2", 2, cap);
  expect_gradients("g2", 3, CapKind::kSmooth);  // four rings; a sphere's umbilics leave no derivative
}

}  // namespace
}  // namespace umbilic::test
