// SPDX-License-Identifier: MIT
/// \file
/// What a run is expected to take has the units and the order that it must have. How near it comes, the bench measures
/// (`npm run bench -- estimates`).
#include "driver/estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cage/generate.h"
#include "driver/memory.h"
#include "driver/rules.h"
#include "driver/run.h"

namespace umbilic {
namespace {

RunOptions asked(std::string_view functional, int first, int last, bool symmetric = true) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.first_level = first;
  options.last_level = last;
  options.symmetry = symmetric;
  return options;
}

Estimate estimated(std::string_view cage, const RunOptions& options) {
  return umbilic::Run::create(*generate_cage(cage), options)->estimate();
}

LevelSize size_at(std::string_view cage, int level, bool symmetric) {
  const RefinedCage refined = *refine_to_evaluable(*generate_cage(cage), level, symmetric);
  const PatchLayout layout(refined.mesh, CapKind::kSmooth, face_orbits(refined.mesh, refined.symmetry));
  const int unknowns = Coordinates(refined.mesh, refined.symmetry).count();
  return level_size(refined.level, refined.level, layout, refined.mesh.face_count(), refined.symmetry.order, unknowns);
}

/// By shape and valence, so that their order does not matter.
double sectors(const LevelSize& size, int valence, CapShape shape) {
  double sum = 0;
  for (const CapCorners& corners : size.corners) {
    if (corners.valence == valence && corners.shape == shape) sum += corners.sectors;
  }
  return sum;
}

TEST(Estimate, of_a_finer_level_has_the_patches_that_its_layout_has) {
  for (const char* cage : {"two-3", "cube", "dodecahedron-frame", "torus"}) {
    for (const bool symmetric : {true, false}) {
      const LevelSize first = size_at(cage, 1, symmetric);
      for (int level = 2; level <= 3; ++level) {
        const LevelSize told = level_size_after(first, level, first.level), real = size_at(cage, level, symmetric);
        EXPECT_EQ(told.faces, real.faces) << cage;
        EXPECT_EQ(told.order, real.order) << cage;
        EXPECT_NEAR(told.unknowns, real.unknowns, 0.2 * real.unknowns) << cage << level;
        for (const int valence : {3, 5, 6, 8}) {
          for (const CapShape shape : {CapShape::kOneRing, CapShape::kTwoRing, CapShape::kFourRing})
            EXPECT_EQ(sectors(told, valence, shape), sectors(real, valence, shape)) << cage << level;
        }
      }
    }
  }
}

TEST(Estimate, counts_the_samples_of_the_layout) {
  const QuadratureRule rule = minimizing_rule(CapKind::kSmooth, *weights_of("bending"));
  for (const char* cage : {"two-3", "cube", "torus"}) {
    const LevelSize size = level_size_after(size_at(cage, 1, false), 3, 0);
    const SampleCounts counts = sample_counts(size, rule);
    const RefinedCage refined = *refine_to_evaluable(*generate_cage(cage), 3, false);
    double regular = 0, capped = 0, columns = 0;
    const PatchLayout layout(refined.mesh, CapKind::kSmooth);
    for (const PatchSet& set : layout.sets()) {
      const double samples = set.count() * static_cast<double>(samples_of(set.kind, rule).size());
      (set.kind.regular() ? regular : capped) += samples;
      if (!set.kind.regular()) columns += samples * set.columns;
    }
    EXPECT_EQ(counts.regular, regular) << cage;
    EXPECT_EQ(counts.capped, capped) << cage;
    EXPECT_NEAR(counts.columns, columns, 0.15 * columns) << cage;  // its patches' columns differ a little
  }
}

TEST(Estimate, grows_with_the_levels_and_without_symmetry_and_from_second_to_third_order) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    double before = 0;
    for (int last = 0; last <= 5; ++last) {
      const double seconds = estimated("two-3", asked(functional, 0, last)).seconds;
      EXPECT_GT(seconds, before);
      before = seconds;
    }
    EXPECT_GT(estimated("two-3", asked(functional, 0, 3, false)).seconds,
              estimated("two-3", asked(functional, 0, 3)).seconds);
  }
  EXPECT_GT(estimated("two-3", asked("mvs_cross", 0, 3)).seconds, estimated("two-3", asked("bending", 0, 3)).seconds);
}

TEST(Estimate, of_a_better_accuracy_takes_no_fewer_levels) {
  std::size_t before = 0;
  for (const double accuracy : {0.05, 0.01, 0.003}) {
    RunOptions options = asked("mvs_cross", 0, 2);
    options.accuracy = accuracy;
    const std::size_t levels = estimated("two-3", options).levels.size();
    EXPECT_GE(levels, before);
    EXPECT_GE(levels, 3U);  // fewer tell no error
    before = levels;
  }
}

TEST(Estimate, of_memory_is_that_by_which_runs_are_refused) {
  for (const bool symmetric : {true, false}) {
    const Estimate estimate = estimated("two-3", asked("bending", 0, 4, symmetric));
    double largest = 0;
    for (const LevelEstimate& level : estimate.levels) {
      EXPECT_EQ(level.bytes, run_bytes(level.patches, level.patches / (symmetric ? 12 : 1), MetricChoice::kAutomatic));
      largest = std::max(largest, level.bytes);
    }
    EXPECT_EQ(estimate.bytes, largest);
    EXPECT_EQ(estimate.levels.back().patches, 24 * std::pow(4., 4));
  }
}

TEST(Estimate, is_a_number_for_every_cage_functional_and_metric) {
  for (const char* cage : {"cube", "torus", "two-3", "dodecahedron-frame", "disk", "n-sided"}) {
    for (const std::string_view functional : kFunctionalNames) {
      for (int metric = 0; metric < kMetricChoiceCount; ++metric) {
        RunOptions options = asked(functional, 0, 2, metric % 2 == 0);
        options.metric = static_cast<MetricChoice>(metric);
        const Estimate estimate = estimated(cage, options);
        double sum = 0;
        EXPECT_EQ(estimate.levels.size(), 3U);
        for (const LevelEstimate& level : estimate.levels) {
          EXPECT_GT(level.seconds, 0) << cage << ' ' << functional;
          EXPECT_TRUE(std::isfinite(level.seconds) && std::isfinite(level.bytes) && std::isfinite(level.unknowns));
          EXPECT_GE(level.evaluations, 1);
          sum += level.seconds;
        }
        EXPECT_DOUBLE_EQ(estimate.seconds, sum);
      }
    }
  }
}

/// Whatever the clock says, what is done never becomes less.
TEST(Estimate, progress_of_a_run_moves_from_0_to_1_and_never_back) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), asked(functional, 0, 2));
    EXPECT_EQ(run.progress().share_done, 0);
    EXPECT_GT(run.progress().seconds_left, 0);
    double before = 0;
    while (!run.step(1)) {
      const Progress& now = run.progress();
      EXPECT_GE(now.share_done, before);
      EXPECT_LT(now.share_done, 1);
      EXPECT_GT(now.seconds_left, 0);
      EXPECT_TRUE(std::isfinite(now.seconds_left));
      before = now.share_done;
    }
    EXPECT_GT(before, 0);
    EXPECT_EQ(run.progress().share_done, 1);
    EXPECT_EQ(run.progress().seconds_left, 0);
  }
}

/// A forecast for levels of 1 and 4 units of work learns from the clock: here all takes ten times as long as told.
TEST(Estimate, what_is_left_follows_the_seconds_that_work_has_taken) {
  const RunOptions options = asked("mvs_cross", 3, 4, false);
  const LevelSize size = size_at("two-3", 3, false);
  Forecast forecast(size, 0, options);
  const Estimate before = forecast.estimate();
  const int evaluations = static_cast<int>(before.levels[0].evaluations);
  forecast.level_ended(3, evaluations, 10 * before.levels[0].seconds);
  EXPECT_GT(forecast.seconds_left(), 5 * before.levels[1].seconds);
  EXPECT_LT(forecast.seconds_left(), 11 * before.levels[1].seconds);
}

TEST(Estimate, a_run_that_goes_on_from_a_minimized_surface_takes_less) {
  const LevelSize size = size_at("two-3", 2, true);
  const RunOptions options = asked("mvs_cross", 2, 2);
  EXPECT_LT(Forecast(size, 0, options, true).estimate().seconds, Forecast(size, 0, options).estimate().seconds);
}

}  // namespace
}  // namespace umbilic
