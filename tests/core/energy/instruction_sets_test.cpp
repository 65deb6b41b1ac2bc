// SPDX-License-Identifier: MIT
/// \file
/// Energies, their gradients and all integrals by the kernels of every instruction set.
#include <gtest/gtest.h>

#include "base/each_instruction_set.h"
#include "energy/energy_hessian.h"
#include "energy/surface_energy.h"
#include "mesh/rough_cages.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

/// Each functional alone, then all of them.
std::vector<Weights> all_weights() {
  std::vector<Weights> all{{0.3, 0.2, 1e-3, 2e-3, 1e-3, 3e-3, 2e-3, 1e-5}};
  for (int f = 0; f < kFunctionalCount; ++f) {
    Weights single{};
    single[f] = 1;
    all.push_back(single);
  }
  return all;
}

TEST(InstructionSets, agree_on_energies_and_gradients_with_every_functional_and_cap) {
  for (const CapKind cap : kAllCaps) {
    const Refined mesh = rough(trapezohedron(5), 2, 0.01, 8);
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, {4, 5, 1});
    for (const Weights& weights : all_weights()) {
      const SurfaceEnergy energy(jets, weights);
      EnergyValue expected;
      Points expected_gradient;
      with_each_instruction_set([&](InstructionSet set) {
        Points gradient;
        const EnergyValue value = energy.evaluate(mesh.control, &gradient);
        if (set == InstructionSet::kPortable) {
          expected = value;
          expected_gradient = gradient;
        }
        // Third derivatives near an extraordinary vertex lose some digits.
        EXPECT_NEAR(value.energy / expected.energy, 1, 1e-11);
        for (int p = 0; p < kAreaPowerCount; ++p) {
          EXPECT_NEAR(value.integrals[p], expected.integrals[p], 1e-11 * expected.integrals[p]) << "power " << p;
        }
        EXPECT_NEAR(value.area / expected.area, 1, 1e-13);
        EXPECT_NEAR(value.regularity / expected.regularity, 1, 1e-11);
        EXPECT_LT((gradient - expected_gradient).norm(), 1e-10 * expected_gradient.norm());
        EXPECT_EQ(energy.evaluate(mesh.control, nullptr).energy, value.energy) << "with or without gradient";
      });
    }
  }
}

TEST(InstructionSets, agree_on_all_integrals_with_every_cap) {
  for (const CapKind cap : kAllCaps) {
    const Refined mesh = rough(trapezohedron(5), 2, 0.01, 9);
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, {7, 6, 2});
    SurfaceIntegrals expected;
    with_each_instruction_set([&](InstructionSet set) {
      const SurfaceIntegrals value = surface_integrals(jets, mesh.control);
      if (set == InstructionSet::kPortable) expected = value;
      for (int f = 0; f < kFunctionalCount; ++f) {
        EXPECT_NEAR(value.functionals[f] / expected.functionals[f], 1, 1e-11) << kFunctionalNames[f];
      }
      for (int i = 0; i < kInvariantCount; ++i) {
        EXPECT_NEAR(value.invariants[i] / expected.invariants[i], 1, 1e-10) << kInvariantNames[i];
      }
      EXPECT_NEAR(value.area / expected.area, 1, 1e-13);
      EXPECT_NEAR(value.gaussian, expected.gaussian, 1e-11 * 4 * 3.15);
    });
  }
}

/// The lower triangle of a patch's matrix, and zeros.
Eigen::MatrixXd lower_triangle(const double* block, int columns) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> matrix(block, 3 * columns, 3 * columns);
  return matrix.triangularView<Eigen::Lower>();
}

TEST(InstructionSets, agree_on_second_derivatives_with_every_functional_and_cap) {
  for (const CapKind cap : kAllCaps) {
    const Refined mesh = rough(trapezohedron(5), 2, 0.01, 8);
    const PatchLayout layout(mesh.mesh, cap);
    const QuadratureRule rule{3, 4, 1};
    const JetEvaluator jets(layout, rule);
    for (const Weights& weights : all_weights()) {
      EnergyHessian hessian(layout, rule, weights);
      hessian.move_to(mesh.control, SurfaceEnergy(jets, weights).evaluate(mesh.control, nullptr));
      for (int s = 0; s < static_cast<int>(layout.sets().size()); ++s) {
        Eigen::MatrixXd expected;
        with_each_instruction_set([&](InstructionSet set) {
          HessianMemory memory;
          std::vector<double> block;
          hessian.patch(s, 0, memory, block);
          const Eigen::MatrixXd matrix = lower_triangle(block.data(), hessian.columns(s));
          if (set == InstructionSet::kPortable) expected = matrix;
          EXPECT_LT((matrix - expected).norm(), 1e-11 * expected.norm()) << name_of(set);
        });
      }
    }
  }
}

}  // namespace
}  // namespace umbilic::test
