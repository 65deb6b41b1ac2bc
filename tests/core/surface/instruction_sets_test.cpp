// SPDX-License-Identifier: MIT
/// \file
/// Jets and their pullbacks by the kernels of every instruction set.
#include <gtest/gtest.h>

#include "base/each_instruction_set.h"
#include "mesh/rough_cages.h"
#include "surface/jets.h"

namespace umbilic::test {
namespace {

/// Jets in `all`; their adjoints are other numbers of the same size.
std::vector<Points> jets_and_pull_back(const JetEvaluator& jets, const Points& control, int derivatives,
                                       std::vector<double>& all) {
  const std::vector<AdjointChannel> channels{{derivatives}, {kFirstOrderCount}, {kSecondOrderCount}};
  std::vector<Points> gradients;
  all.clear();
  jets.evaluate(
      control, derivatives, channels,
      [&](int, const JetBlock& block) {
        all.insert(all.end(), block.jets, block.jets + 3 * block.derivatives * block.samples * block.patches);
        Random random(7);
        for (std::size_t k = 0; k < channels.size(); ++k) {
          const int size = 3 * channels[k].derivatives * block.samples * block.patches;
          for (int i = 0; i < size; ++i) block.adjoints[k][i] = random();
        }
      },
      gradients);
  return gradients;
}

double difference(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

TEST(InstructionSets, agree_on_jets_and_pull_backs_with_every_cap_and_rule) {
  for (const CapKind cap : {CapKind::kNone, CapKind::kFlat, CapKind::kSmooth}) {
    const Refined mesh = rough(trapezohedron(5), 2, 0.03, 3);
    const PatchLayout layout(mesh.mesh, cap);
    // Those with loops of constant length, and those with one lane more than a multiple.
    for (const QuadratureRule& rule : {QuadratureRule{4, 6, 1}, QuadratureRule{7, 3, 2}, QuadratureRule{5, 5, 0}}) {
      const JetEvaluator jets(layout, rule);
      for (const int derivatives : {kSecondOrderCount, kThirdOrderCount}) {
        std::vector<double> expected_jets;
        std::vector<Points> expected;
        with_each_instruction_set([&](InstructionSet set) {
          std::vector<double> all;
          const std::vector<Points> gradients = jets_and_pull_back(jets, mesh.control, derivatives, all);
          if (set == InstructionSet::kPortable) {
            expected_jets = all;
            expected = gradients;
          }
          const auto size = static_cast<Eigen::Index>(all.size());
          // Sums of some hundred products, whose derivatives near an extraordinary vertex are of very different size.
          EXPECT_LT(difference(Eigen::Map<Eigen::VectorXd>(all.data(), size),
                               Eigen::Map<Eigen::VectorXd>(expected_jets.data(), size)),
                    1e-13);
          for (std::size_t k = 0; k < gradients.size(); ++k) {
            EXPECT_LT(difference(gradients[k].reshaped(), expected[k].reshaped()), 1e-12)
                << name_of(set) << " channel " << k;
          }
        });
      }
    }
  }
}

}  // namespace
}  // namespace umbilic::test
