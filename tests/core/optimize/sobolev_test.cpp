// SPDX-License-Identifier: MIT
/// \file
/// The Sobolev metric as an inner product: symmetric, positive, and covariant under similarities.
#include "optimize/sobolev.h"

#include <gtest/gtest.h>

#include <random>

#include "cage/generate.h"
#include "energy/single_weight.h"
#include "energy/surface_energy.h"
#include "mesh/rough_cages.h"
#include "solve/identity_metric.h"
#include "solve/lbfgs.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

Refined genus_two() { return refined(*generate_cage("two-3"), 1); }

Eigen::VectorXd random_vector(int size, int seed) {
  std::mt19937 random(seed);
  Eigen::VectorXd v(size);
  for (int i = 0; i < size; ++i) v[i] = 2.0 * random() / std::mt19937::max() - 1;
  return v;
}

Eigen::VectorXd solve(const PatchLayout& layout, const Weights& weights, const Points& control,
                      const Eigen::VectorXd& right) {
  const JetEvaluator jets(layout, {4, 4, 2});
  const SurfaceEnergy energy(jets, weights);
  const Unknowns unknowns{Coordinates(layout.control_count())};
  SobolevMetric metric(energy, unknowns);
  metric.begin(control);
  while (!metric.advance()) {
  }
  return metric.solve(right);
}

class SurfaceFunction : public Objective {
 public:
  explicit SurfaceFunction(const SurfaceEnergy& energy) : energy_(energy) {}
  void evaluate(const Eigen::VectorXd& x, Evaluation& result) const override {
    Points gradient;
    result.value = energy_.evaluate(Eigen::Map<const Points>(x.data(), x.size() / 3, 3), &gradient).energy;
    result.gradient = Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size());
  }

 private:
  const SurfaceEnergy& energy_;
};

class SobolevMetricOfEveryCap : public testing::TestWithParam<CapKind> {};

TEST_P(SobolevMetricOfEveryCap, is_symmetric_and_positive_definite) {
  const Refined f = genus_two();
  const PatchLayout layout(f.mesh, GetParam());
  const Eigen::VectorXd a = random_vector(int(f.control.size()), 1), b = random_vector(int(f.control.size()), 2);
  const Eigen::VectorXd to_a = solve(layout, only(kBending), f.control, a),
                        to_b = solve(layout, only(kBending), f.control, b);
  EXPECT_GT(a.dot(to_a), 0);
  EXPECT_GT(b.dot(to_b), 0);
  EXPECT_NEAR(a.dot(to_b), b.dot(to_a), 1e-9 * std::sqrt(a.dot(to_a) * b.dot(to_b)));
}

/// Energies have no units, so the metric has those of 1/length^2.
TEST_P(SobolevMetricOfEveryCap, scales_with_the_inverse_square_of_the_size_and_turns_with_the_surface) {
  const Refined f = genus_two();
  const PatchLayout layout(f.mesh, GetParam());
  for (const int functional : {int(kBending), int(kMvsCross)}) {
    const Eigen::VectorXd right = random_vector(int(f.control.size()), 3);
    const Eigen::VectorXd expected = solve(layout, only(functional), f.control, right);
    const Eigen::VectorXd scaled = solve(layout, only(functional), 3 * f.control, right);
    EXPECT_LT((scaled - 9 * expected).norm(), 1e-8 * scaled.norm());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
    const auto turned = [&](const Eigen::VectorXd& v) {
      const Points rows = Eigen::Map<const Points>(v.data(), v.size() / 3, 3) * turn.transpose();
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(rows.data(), rows.size()));
    };
    const Eigen::VectorXd answer = solve(layout, only(functional), f.control * turn.transpose(), turned(right));
    EXPECT_LT((answer - turned(expected)).norm(), 1e-8 * expected.norm());
  }
}

/// Euler's theorem: gradients of energies of degree 0 have no part along the position, and neither has the answer.
TEST_P(SobolevMetricOfEveryCap, leaves_the_size_alone) {
  const Refined f = genus_two();
  const PatchLayout layout(f.mesh, GetParam());
  const Points position = f.control.rowwise() - f.control.colwise().mean();
  const Eigen::Map<const Eigen::VectorXd> x(position.data(), position.size());
  const Eigen::VectorXd answer = solve(layout, only(kMvsCross), f.control, random_vector(int(f.control.size()), 4));
  EXPECT_LT(std::abs(x.dot(answer)), 1e-10 * x.norm() * answer.norm());
}

INSTANTIATE_TEST_SUITE_P(Caps, SobolevMetricOfEveryCap, testing::ValuesIn(kAllCaps));

/// The energy is a squared seminorm of the same order, so this metric takes out its stiffness.
TEST(SobolevMetricSlow, leaves_less_than_half_of_what_the_plain_gradient_leaves_of_a_third_order_energy) {
  const Refined coarse = genus_two();
  const Refinement finer = catmull_clark(coarse.mesh);
  const Points control = finer.stencil * coarse.control;
  const PatchLayout layout(finer.mesh, CapKind::kSmooth);
  const JetEvaluator jets(layout, {4, 4, 2});
  const SurfaceEnergy energy(jets, only(kMvsCross));
  const SurfaceFunction objective(energy);
  const Unknowns unknowns{Coordinates(layout.control_count())};
  SobolevMetric sobolev(energy, unknowns);
  sobolev.begin(control);
  while (!sobolev.advance()) {
  }
  const Identity identity;
  const auto after = [&](const Metric& metric, int evaluations) {
    LbfgsOptions options;
    options.max_displacement = 0.1;
    Lbfgs lbfgs(objective, metric, Eigen::Map<const Eigen::VectorXd>(control.data(), control.size()), options);
    for (int i = 0; i < evaluations; ++i) lbfgs.step();
    return lbfgs.best_value();
  };
  constexpr double kMinimum = 4165;  // of this mesh, by 1000 iterations
  const double guided = after(sobolev, 100) - kMinimum, plain = after(identity, 100) - kMinimum;
  EXPECT_GT(guided, 0);
  EXPECT_LT(guided, 0.5 * plain);
}

}  // namespace
}  // namespace umbilic::test
