// SPDX-License-Identifier: MIT
/// \file
/// The counts are medians over the bench's runs; the words beside them tell the spread.
#include "driver/estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "driver/accuracy.h"
#include "driver/machine_speed.h"
#include "driver/memory.h"
#include "driver/metric_for_level.h"

namespace umbilic {
namespace {

/// Evaluations by level: of those before the first that can be evaluated, of this one, and of those after it.
using Counts = std::array<double, 5>;
constexpr Counts kSymmetricSecondCounts{10, 18, 28, 90, 55}, kSymmetricThirdCounts{10, 16, 26, 65, 150};
constexpr Counts kSphereSobolevCounts{10, 0, 40, 25, 25}, kSobolevCounts{10, 0, 120, 220, 60};
constexpr Counts kThirdSobolevCounts{10, 150, 300, 600, 800};
constexpr Counts kNewtonCounts{40, 65, 135, 370, 370}, kIdentityCounts{150, 300, 800, 900, 900};

/// The first level that the Sobolev product minimizes, far from the minimum, takes an evaluation for each unknown, as
/// long as there are few.
double first_sobolev(double unknowns) { return unknowns / (1 + unknowns / 450); }

/// Evaluations for each metric that is built, and how many are built at least.
struct Metrics {
  double evaluations, least;
};
constexpr Metrics kHessianMetrics{14, 2.5}, kSobolevMetrics{25, 1};

const Counts& counts_of(MetricChoice metric, bool third_order, const LevelSize& size) {
  if (metric == MetricChoice::kIdentity) return kIdentityCounts;
  if (metric == MetricChoice::kSobolev) {
    if (third_order) return kThirdSobolevCounts;
    return size.genus > 1 ? kSobolevCounts : kSphereSobolevCounts;
  }
  if (size.order == 1) return kNewtonCounts;
  return third_order ? kSymmetricThirdCounts : kSymmetricSecondCounts;
}

/// The tolerance of the tables, and what each power of ten saves beyond it.
constexpr double kTableDigits = 6, kPerDigit = 0.1, kLeastPart = 0.4;
/// What a start near the minimum saves.
constexpr double kNearPart = 0.5;

/// Patches from which threads share an evaluation.
constexpr double kLarge = 100;

/// How many evaluations are left after n of N. Some levels take many times as many as usual, so that those which have
/// taken more will probably take longer.
double evaluations_left(double n, double expected) {
  constexpr double kTail = 0.3;
  return std::max(expected - n, kTail * std::max(n, expected));
}

/// Work in seconds of the rates' machine that weighs as much as what was told of this one before the run.
constexpr double kTrust = 0.1;

}  // namespace

ExpectedCounts expected_counts(const LevelSize& size, int number, const RunOptions& options, bool near) {
  const bool third = third_order(options.weights);
  const MetricChoice metric = metric_for_level(options.metric, third, size.order, size.unknowns);
  const Counts& counts = counts_of(metric, third, size);
  const double digits = -std::log10(std::max(tolerance_of(options), 1e-12));
  double evaluations = counts[std::clamp(number + 1, 0, 4)];
  if (number == 0 && metric == MetricChoice::kSobolev && !third) evaluations = first_sobolev(size.unknowns);
  if (number >= 0) evaluations *= std::max(kLeastPart, 1 + kPerDigit * (digits - kTableDigits));
  if (near) evaluations *= kNearPart;
  evaluations = std::min(evaluations, options.max_iterations + 1.);
  if (size.unknowns == 0) evaluations = 1;
  if (metric == MetricChoice::kIdentity) return {evaluations, 0};
  const Metrics& metrics = metric == MetricChoice::kSobolev ? kSobolevMetrics : kHessianMetrics;
  return {evaluations, metrics.least + evaluations / metrics.evaluations};
}

int expected_levels(const RunOptions& options, int at_most) {
  if (!options.accuracy) return at_most;
  // Three levels tell an error; the error of third-order energies falls to a quarter from each level to the next.
  int levels = 3;
  if (*options.accuracy < 0.02) ++levels;
  if (*options.accuracy < 0.005) ++levels;
  if (!third_order(options.weights) && levels > 3) --levels;
  return std::min(levels, at_most);
}

double Forecast::Planned::slowness() const { return machine_slowness(size.patches() >= kLarge); }

Forecast::Forecast(const LevelSize& first, int required, const RunOptions& options, bool near) {
  const int first_evaluable = std::max(first.level, required);
  const int count = expected_levels(options, options.last_level - first_evaluable + 1);
  const int last = std::max(first.level, options.accuracy ? first_evaluable + count - 1 : options.last_level);
  const bool third = third_order(options.weights);
  for (int number = first.level; number <= last; ++number) {
    Planned level;
    level.size = level_size_after(first, number, required);
    level.expected = expected_counts(level.size, number - first_evaluable, options, near && number == first.level);
    level.work = level_work(level.size, options.weights,
                            metric_for_level(options.metric, third, level.size.order, level.size.unknowns));
    level.bytes = run_bytes(level.size.mesh_faces, level.size.mesh_faces / level.size.order, options.metric);
    levels_.push_back(std::move(level));
  }
}

const Forecast::Planned* Forecast::find(int level) const {
  const auto found =
      std::find_if(levels_.begin(), levels_.end(), [&](const Planned& known) { return known.size.level == level; });
  return found == levels_.end() ? nullptr : &*found;
}

Estimate Forecast::estimate() const {
  Estimate estimate;
  for (const Planned& level : levels_) {
    const double seconds = level.seconds() * level.slowness();
    estimate.levels.push_back({level.size.level, level.size.mesh_faces, std::round(level.size.unknowns),
                               std::round(level.expected.evaluations), seconds, level.bytes});
    estimate.seconds += seconds;
    estimate.bytes = std::max(estimate.bytes, level.bytes);
  }
  return estimate;
}

/// What was measured before the run counts for less, the more the run has done.
double Forecast::slowness_of(const Planned& level) const {
  double seconds = kTrust * level.slowness() + ended_seconds_, work = kTrust + ended_work_;
  if (const Planned* current = find(level_); current && evaluations_ > 0) {
    seconds += seconds_;
    work += current->work.set_up + evaluations_ * current->each();
  }
  return seconds / work;
}

double Forecast::seconds_left() const {
  double left = 0;
  for (const Planned& level : levels_) {
    if (level.size.level < level_) continue;
    double work = level.seconds();
    if (level.size.level == level_ && evaluations_ > 0)
      work = evaluations_left(evaluations_, level.expected.evaluations) * level.each();
    left += work * slowness_of(level);
  }
  if (const Planned* level = find(repeated_)) {
    left += evaluations_left(repeated_evaluations_, kNearPart * level->expected.evaluations) * level->each() *
            slowness_of(*level);
  }
  return left;
}

void Forecast::update() {
  const double spent = ended_seconds_ + seconds_ + repeated_seconds_, all = spent + seconds_left();
  if (all > 0) share_ = std::clamp(spent / all, share_, 1.);
}

void Forecast::level_advanced(int level, int evaluations, double seconds) {
  level_ = level;
  evaluations_ = evaluations;
  seconds_ = std::max(seconds, 0.);
  update();
}

void Forecast::level_repeated(int level, int evaluations, double seconds) {
  repeated_ = level;
  repeated_evaluations_ = evaluations;
  repeated_seconds_ = std::max(seconds, 0.);
  update();
}

void Forecast::repetition_ended() {
  ended_seconds_ += repeated_seconds_;
  if (const Planned* known = find(repeated_)) ended_work_ += repeated_evaluations_ * known->each();
  repeated_ = -1;
  repeated_evaluations_ = 0;
  repeated_seconds_ = 0;
  update();
}

void Forecast::level_ended(int level, int evaluations, double seconds) {
  ended_seconds_ += std::max(seconds, 0.);
  if (const Planned* known = find(level)) ended_work_ += known->work.set_up + evaluations * known->each();
  level_ = level + 1;
  evaluations_ = 0;
  seconds_ = 0;
  update();
}

}  // namespace umbilic
