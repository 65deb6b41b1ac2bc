// SPDX-License-Identifier: MIT
/// \file
/// Minimizing in symmetric coordinates takes the steps that minimizing in all of them takes from a symmetric start.
#include <gtest/gtest.h>

#include "cage/generate.h"
#include "driver/surface.h"
#include "driver/surface_objective.h"
#include "mesh/rough_cages.h"
#include "optimize/sobolev.h"
#include "solve/lbfgs.h"

namespace umbilic::test {
namespace {

/// The identity in the scale of a first step of this length; B keeps lengths.
class Identity : public Metric {
 public:
  Identity(double length, const Eigen::VectorXd& first_gradient) : factor_(length / first_gradient.norm()) {}
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override { return factor_ * gradient; }

 private:
  double factor_;
};

/// The first energies of a minimization that keeps the cage's symmetry or does not know of it.
std::vector<double> energies(const Cage& cage, bool symmetric, bool sobolev, const Weights& weights, CapKind cap) {
  const Surface surface(*refine_to_evaluable(cage, 1, symmetric), cap, weights);
  const Unknowns unknowns{Coordinates(surface.mesh(), surface.symmetry())};
  EXPECT_EQ(unknowns.coordinates().free(), !symmetric);
  const SurfaceObjective objective(surface.energy(), unknowns, surface.expected_gaussian(), surface.start());
  SobolevMetric metric(surface.energy(), unknowns);
  metric.begin(surface.start());
  while (!metric.advance()) {
  }
  const Eigen::VectorXd start = unknowns.coordinates().unknowns(surface.start());
  Evaluation now;
  objective.evaluate(start, now);
  const Identity identity(0.1, now.gradient);
  const Metric& chosen = sobolev ? static_cast<const Metric&>(metric) : identity;
  Lbfgs lbfgs(objective, chosen, start, {});
  std::vector<double> result;
  for (int i = 0; i < 10; ++i) {
    lbfgs.step();
    result.push_back(lbfgs.best_value());
  }
  return result;
}

void expect_the_same_steps(const char* name, FrameFamily family, const Weights& weights, CapKind cap) {
  const Cage cage = *generate_cage(name, {.family = family});
  for (const bool sobolev : {false, true}) {
    SCOPED_TRACE(std::string(name) + (sobolev ? ", Sobolev metric" : ", identity"));
    const std::vector<double> reduced = energies(cage, true, sobolev, weights, cap);
    const std::vector<double> all = energies(cage, false, sobolev, weights, cap);
    EXPECT_LT(all.back(), all.front());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(reduced[i] / all[i], 1, 1e-8) << "evaluation " << i;
  }
}

TEST(ReducedCoordinates, take_the_same_first_steps_as_all_coordinates) {
  const Weights bending{1, 0, 0, 0, 0, 0}, variation{0, 0, 0, 1, 0, 0}, blend{0.5, 0, 0, 0, 0.01, 0};
  expect_the_same_steps("two-3", FrameFamily::kFlag, bending, CapKind::kSmooth);
  expect_the_same_steps("two-3", FrameFamily::kFlag, variation, CapKind::kSmooth);
  expect_the_same_steps("tetrahedron-frame", FrameFamily::kFlag, blend, CapKind::kSmooth);
  expect_the_same_steps("two-4", FrameFamily::kHub, bending, CapKind::kSmooth);
  expect_the_same_steps("torus", FrameFamily::kFlag, variation, CapKind::kSmooth);
  expect_the_same_steps("two-3", FrameFamily::kFlag, variation, CapKind::kFlat);
  expect_the_same_steps("two-3", FrameFamily::kFlag, bending, CapKind::kNone);
}

}  // namespace
}  // namespace umbilic::test
