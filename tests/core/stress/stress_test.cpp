// SPDX-License-Identifier: MIT
/// \file
/// What holds of a run whatever its cage: hostile cages times all functionals, levels 0 to 2.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "driver/run.h"
#include "energy/lower_bounds.h"
#include "mesh/components.h"
#include "stress/cages.h"

namespace umbilic::test {
namespace {

using Energies = std::array<double, kFunctionalCount>;

Weights only(int functional) {
  Weights weights{};
  weights[functional] = 1;
  return weights;
}

umbilic::Run finished(const Cage& cage, int functional, int iterations, int last_level = 2) {
  RunOptions options;
  options.weights = only(functional);
  options.max_iterations = iterations;
  options.last_level = last_level;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(100)) {
  }
  return run;
}

bool claims_a_minimum(const LevelReport& level) {
  return level.stop == StopReason::kConverged || level.stop == StopReason::kRoundOff;
}

void expect_numbers(const umbilic::Run& run) {
  for (const LevelReport& level : run.levels()) {
    if (level.stop == StopReason::kNotFinite) {
      EXPECT_FALSE(level.credible);
      continue;
    }
    EXPECT_TRUE(std::isfinite(level.energy)) << "level " << level.level;
    EXPECT_TRUE(std::isfinite(level.energy_reported)) << "level " << level.level;
  }
  for (const double energy : run.energies().functionals) EXPECT_FALSE(std::isnan(energy));
  EXPECT_TRUE(run.control_mesh().vertices.allFinite());
}

/// Bounds with what a quadrature that is good to a percent may miss of them.
double least_energy(const Cage& cage, int functional) {
  return 0.99 * lower_bound(only(functional), find_components(PolygonMesh(cage)).genera);
}

void expect_bounds(const umbilic::Run& run, const Cage& cage, int functional) {
  const double least = least_energy(cage, functional);
  for (const LevelReport& level : run.levels()) {
    if (claims_a_minimum(level)) {
      EXPECT_GE(level.energy_reported, least) << "level " << level.level;
    }
    if (level.energy_reported < least) {
      EXPECT_FALSE(level.credible);
    }
  }
  const LimitReport limit = run.limit();
  if (limit.status == LimitStatus::kConverging) {
    EXPECT_GE(limit.energy, least);
    EXPECT_GE(limit.lower, least);
  }
  if (run.energies().credible()) {
    EXPECT_GE(run.energies().functionals[kBending], least_energy(cage, kBending));
  }
}

/// Of levels whose energies may be believed as much as the result's.
void expect_best(const umbilic::Run& run, double least) {
  const LevelReport& result = run.result();
  for (const LevelReport& level : run.levels()) {
    if (!level.evaluable || level.stop == StopReason::kBelowBound || level.stop == StopReason::kNotFinite) continue;
    if (level.energy_reported < least) continue;
    EXPECT_TRUE(result.credible || !level.credible) << "level " << level.level;
    if (level.credible == result.credible && result.evaluable) {
      EXPECT_GE(level.energy_reported, result.energy_reported) << "level " << level.level;
    }
  }
}

/// The largest changes of the energies when all coordinates change by as much as they are rounded: more where curvature
/// is large compared with the size.
Energies changes_by_rounding(const Cage& mesh, const Energies& energies) {
  const double size = mesh.vertices.cwiseAbs().maxCoeff();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> rounding(-size * 0x1p-52, size * 0x1p-52);
  Energies largest{};
  for (int copy = 0; copy < 3; ++copy) {
    Cage moved = mesh;
    for (double& x : moved.vertices.reshaped()) x += rounding(random);
    const EvaluationReport report = *evaluate(moved, CapKind::kSmooth, 0);
    for (int f = 0; f < kFunctionalCount; ++f) {
      largest[f] = std::max(largest[f], std::abs(report.energies.functionals[f] - energies[f]));
    }
  }
  return largest;
}

/// Energies of the written surface are the run's. The points of a run are rounded from one patch of each orbit, those
/// that are written from all patches; each is a sum of many products, off by many roundings.
void expect_reproduced(const umbilic::Run& run) {
  const Energies& energies = run.energies().functionals;
  const EvaluationReport again = *evaluate(run.control_mesh(), CapKind::kSmooth, 0);
  std::optional<Energies> changes;
  for (int f = 0; f < kFunctionalCount; ++f) {
    if (std::abs(again.energies.functionals[f] - energies[f]) <= 1e-12 * energies[f]) continue;
    if (!changes) changes = changes_by_rounding(run.control_mesh(), again.energies.functionals);
    EXPECT_NEAR(again.energies.functionals[f], energies[f], 100 * (*changes)[f]) << kFunctionalNames[f];
  }
  EXPECT_EQ(again.energies.credible(), run.energies().credible());
}

void expect_all(const StressCage& stress, int functional, int iterations, int last_level = 2) {
  SCOPED_TRACE(stress.name + ", " + std::string(kFunctionalNames[functional]));
  const umbilic::Run run = finished(stress.cage, functional, iterations, last_level);
  expect_numbers(run);
  expect_bounds(run, stress.cage, functional);
  expect_best(run, least_energy(stress.cage, functional));
  expect_reproduced(run);
}

void expect_same_bytes(const StressCage& stress, int functional, int iterations) {
  SCOPED_TRACE(stress.name + ", " + std::string(kFunctionalNames[functional]));
  const umbilic::Run a = finished(stress.cage, functional, iterations),
                     b = finished(stress.cage, functional, iterations);
  EXPECT_EQ(a.control_mesh().vertices, b.control_mesh().vertices);
  EXPECT_EQ(a.energies().functionals, b.energies().functionals);
}

TEST(Stress, cages_are_forty_and_more) { EXPECT_GE(stress_cages().size(), 40u); }

TEST(Stress, keeps_what_holds_of_all_runs_for_one_functional_of_each_cage) {
  int functional = 0;
  for (const StressCage& stress : stress_cages()) expect_all(stress, functional++ % kFunctionalCount, 2, 1);
}

TEST(StressSlow, keeps_what_holds_of_all_runs_for_all_functionals) {
  for (const StressCage& stress : stress_cages()) {
    for (int functional = 0; functional < kFunctionalCount; ++functional) expect_all(stress, functional, 2);
  }
}

TEST(StressSlow, keeps_what_holds_of_all_runs_for_many_iterations) {
  for (const StressCage& stress : stress_cages()) {
    expect_all(stress, kBending, 60);
    expect_all(stress, kMvsCross, 6);
  }
}

TEST(StressSlow, repeats_every_byte) {
  for (std::size_t i = 0; i < stress_cages().size(); ++i) {
    expect_same_bytes(stress_cages()[i], static_cast<int>(i) % kFunctionalCount, 5);
  }
}

}  // namespace
}  // namespace umbilic::test
