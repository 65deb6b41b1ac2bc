// SPDX-License-Identifier: MIT
/// \file
/// Energies and gradients have the same bits from any number of threads.
#include <gtest/gtest.h>

#include <vector>

#include "base/with_threads.h"
#include "energy/surface_energy.h"
#include "mesh/rough_cages.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

void expect_same_bits(const std::vector<Weights>& functionals) {
  const Refined mesh = rough(trapezohedron(5), 3, 0.01, 8);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    for (const Weights& weights : functionals) {
      EnergyValue expected;
      Points slope;
      SurfaceIntegrals integrals;
      for (const int threads : kThreadCounts) {
        const WithThreads with(threads);
        const JetEvaluator jets(layout, {4, 5, 1});
        const SurfaceEnergy energy(jets, weights);
        ASSERT_GT(jets.block_count(), 7);
        for (int round = 0; round < 3; ++round) {
          Points gradient;
          const EnergyValue value = energy.evaluate(mesh.control, &gradient);
          const SurfaceIntegrals all = surface_integrals(jets, mesh.control);
          if (threads == 1 && round == 0) {
            expected = value;
            slope = gradient;
            integrals = all;
          }
          EXPECT_EQ(value.energy, expected.energy);
          EXPECT_EQ(value.gaussian, expected.gaussian);
          EXPECT_EQ(value.regularity, expected.regularity);
          EXPECT_EQ(gradient, slope);
          EXPECT_EQ(all.functionals, integrals.functionals);
          EXPECT_EQ(all.area, integrals.area);
          EXPECT_EQ(energy.evaluate(mesh.control, nullptr).energy, expected.energy);
        }
      }
    }
  }
}

TEST(SurfaceEnergy, and_its_gradient_have_the_same_bits_from_any_number_of_threads) {
  expect_same_bits({{1, 0, 0, 1}});
}

TEST(SurfaceEnergySlow, of_one_functional_and_its_gradient_have_the_same_bits_from_any_number_of_threads) {
  expect_same_bits({{1}, {0, 0, 0, 1}});
}

}  // namespace
}  // namespace umbilic::test
