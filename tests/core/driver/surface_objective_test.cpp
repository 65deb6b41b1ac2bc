// SPDX-License-Identifier: MIT
/// \file
/// The energy of unknowns, and its guard against curvature that hides between the samples.
#include "driver/surface_objective.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "cage/generate.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

using std::numbers::pi;
constexpr double kCliffordBending = 8 * pi * pi;
constexpr Weights kBendingOnly{1, 0, 0, 0, 0, 0};

/// A refined cage with all its coordinates free.
struct Free {
  Surface surface;
  Unknowns unknowns;

  explicit Free(const Cage& cage, int level, CapKind cap = CapKind::kSmooth)
      : surface(*refine_to_evaluable(cage, level, false), cap, kBendingOnly),
        unknowns(Coordinates(surface.mesh().vertex_count())) {}

  SurfaceObjective objective(int euler_characteristic, const Points& start) const {
    return SurfaceObjective(surface.energy(), unknowns, 2 * std::numbers::pi * euler_characteristic, start);
  }
  Evaluation evaluate(const SurfaceObjective& objective, const Points& control) const {
    Evaluation result;
    objective.evaluate(unknowns.coordinates().unknowns(control), result);
    return result;
  }
};

TEST(SurfaceObjective, is_the_energy_and_its_gradient) {
  const Free torus(*generate_cage("torus"), 0);
  Points gradient;
  const EnergyValue value = torus.surface.energy().evaluate(torus.surface.start(), &gradient);
  const Evaluation result = torus.evaluate(torus.objective(0, torus.surface.start()), torus.surface.start());
  EXPECT_EQ(result.value, value.energy);
  EXPECT_EQ(result.gradient, torus.unknowns.pull_back(gradient));
  EXPECT_FALSE(result.degenerate);
}

TEST(SurfaceObjective, is_infinite_where_the_sampled_curvature_is_not_that_of_the_genus) {
  const Free torus(*generate_cage("torus"), 0);
  const Points& start = torus.surface.start();
  const SurfaceObjective objective = torus.objective(0, start);
  int whole = 0, hidden = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    for (const double amount : {0.01, 0.1, 0.5}) {
      const Points control = start + amount * Random(seed).points(start.rows());
      const EnergyValue value = torus.surface.energy().evaluate(control, nullptr);
      const bool close = std::abs(value.gaussian) <= 0.5;
      ++(close ? whole : hidden);
      const double expected = close ? value.energy : std::numeric_limits<double>::infinity();
      EXPECT_EQ(torus.evaluate(objective, control).value, expected) << amount;
    }
  }
  EXPECT_GE(whole, 10);
  EXPECT_GE(hidden, 5);
}

TEST(SurfaceObjective, of_another_genus_than_the_surfaces_starts_finite_all_the_same) {
  // As if the start were that far from Gauss-Bonnet: a sphere's 4 pi instead of 0.
  const Free torus(*generate_cage("torus"), 0);
  const SurfaceObjective objective = torus.objective(2, torus.surface.start());
  EXPECT_TRUE(std::isfinite(torus.evaluate(objective, torus.surface.start()).value));
}

TEST(SurfaceObjective, is_infinite_far_below_what_any_surface_has_unless_the_start_is_lower) {
  const Free torus(*generate_cage("torus"), 0);
  const Points& start = torus.surface.start();
  const Points fatter = generate_cage("torus", {.ratio = 0.65})->vertices;
  const double energy = torus.surface.energy().evaluate(start, nullptr).energy;
  const auto value = [&](double bound) {
    const SurfaceObjective objective(torus.surface.energy(), torus.unknowns, 0, start, bound);
    return torus.evaluate(objective, fatter).value;
  };
  ASSERT_TRUE(std::isfinite(value(0)));
  ASSERT_LT(value(0), energy);
  EXPECT_EQ(value(value(0)), value(0));
  EXPECT_EQ(value(1.005 * value(0)), value(0)) << "what quadrature may miss";
  EXPECT_TRUE(std::isinf(value(1.02 * value(0))));
  EXPECT_TRUE(std::isinf(value(2 * energy))) << "below its start";
}

TEST(SurfaceObjective, admits_ever_smaller_defects_of_a_start_that_hides_curvature) {
  const Points better = generate_cage("torus")->vertices;
  Cage noisy = *generate_cage("torus");
  noisy.vertices += Random(3).points(better.rows());
  const Free surface(noisy, 0);
  const Points& start = surface.surface.start();
  const auto defect = [&](const Points& control) {
    return std::abs(surface.surface.energy().evaluate(control, nullptr).gaussian);
  };
  ASSERT_GT(defect(start), 1);
  ASSERT_LT(defect(better), 1e-6);
  const SurfaceObjective objective = surface.objective(0, start);
  EXPECT_FALSE(objective.start_is_whole());
  EXPECT_TRUE(std::isfinite(surface.evaluate(objective, better).value));
  EXPECT_TRUE(std::isfinite(surface.evaluate(objective, start).value));
  surface.evaluate(objective, better);
  objective.accept();
  EXPECT_TRUE(std::isfinite(surface.evaluate(objective, better).value));
  EXPECT_TRUE(std::isinf(surface.evaluate(objective, start).value));
}

RunOptions only_bending(int first, int last) {
  RunOptions options;
  options.weights = kBendingOnly;
  options.first_level = first;
  options.last_level = last;
  return options;
}

umbilic::Run finished(const Cage& cage, const RunOptions& options) {
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(100)) {
  }
  return run;
}

/// 50.27 = 16 pi, two spheres, is what a torus that falls apart unseen would report.
TEST(SurfaceObjective, keeps_a_thin_torus_whole_at_every_level) {
  for (const MetricChoice metric : {MetricChoice::kHessian, MetricChoice::kSobolev}) {
    RunOptions options = only_bending(0, 2);
    options.metric = metric;
    const umbilic::Run run = finished(*generate_cage("torus", {.ratio = 0.3}), options);
    // What spline surfaces of so many patches cannot follow of the Clifford torus; falls by 2^4 and more.
    const double excess[] = {2e-3, 1e-4, 1e-5};
    ASSERT_EQ(run.levels().size(), 3u);
    for (const LevelReport& level : run.levels()) {
      EXPECT_GT(level.energy_reported, kCliffordBending * (1 - 1e-8));
      EXPECT_LT(level.energy_reported, kCliffordBending * (1 + excess[level.level]));
    }
    EXPECT_NEAR(run.energies().gaussian, 0, 1e-3);
  }
}

TEST(SurfaceObjective, lets_a_rough_start_with_a_large_defect_run) {
  Cage cage = *generate_cage("torus");
  cage.vertices += 0.5 * Random(3).points(cage.vertices.rows());
  const Free surface(cage, 0);
  const double defect = std::abs(surface.surface.energy().evaluate(surface.surface.start(), nullptr).gaussian);
  EXPECT_GT(defect, 0.5) << "more than is admitted otherwise";
  const umbilic::Run run = finished(cage, only_bending(0, 0));
  EXPECT_NE(run.levels()[0].stop, StopReason::kNotFinite);
  const double start = evaluate(cage, CapKind::kSmooth, 0)->energies.functionals[kBending];
  EXPECT_LT(run.levels()[0].energy, 0.5 * start) << "in which local minimum it ends, rounding decides";
}

}  // namespace
}  // namespace umbilic::test
