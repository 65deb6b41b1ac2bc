// SPDX-License-Identifier: MIT
/// \file
/// Times evaluations of one energy.
#include "driver/machine_speed.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <mutex>

#include "base/instruction_set.h"
#include "base/threads.h"
#include "cage/generate.h"
#include "driver/level_work.h"
#include "driver/surface.h"

namespace umbilic {
namespace {

/// What several threads together gain: not all of the work is shared among them.
constexpr double kSharedPart = 0.85;
double gain_of_threads() {
  const int threads = std::min(thread_count(), hardware_threads());
  return 1 / (1 - kSharedPart + kSharedPart / threads);
}

/// The best of several rounds, with one sample on each thread's own behalf.
double measured_slowness() {
  constexpr double kEnough = 4e-3;
  constexpr int kFewest = 3, kMost = 100;
  Weights weights{};
  weights[kMvsCross] = 1;
  RefinedCage cage = *refine_to_evaluable(*generate_cage("torus"), 0, true);
  const Points control = cage.control;
  const Surface surface(std::move(cage), CapKind::kSmooth, weights);
  const LevelSize size = level_size(0, 0, surface.layout(), 0, surface.symmetry().order, 0);
  Points gradient;
  double best = 1e300, total = 0;
  for (int round = 0; round < kFewest || (total < kEnough && round < kMost); ++round) {
    using Clock = std::chrono::steady_clock;
    constexpr int kTogether = 8;
    const auto begin = Clock::now();
    for (int i = 0; i < kTogether; ++i) surface.energy().evaluate(control, &gradient);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    best = std::min(best, seconds / kTogether);
    total += seconds;
  }
  const double slowness = best / level_work(size, weights, MetricChoice::kIdentity).evaluation;
  return std::isfinite(slowness) && slowness > 0 ? slowness : 1;
}

}  // namespace

double machine_slowness(bool large) {
  static std::mutex mutex;
  static std::array<double, kInstructionSetCount> slowness{};  // of each set; 0 before it is measured
  const std::lock_guard lock(mutex);
  double& known = slowness[static_cast<int>(instruction_set())];
  if (known == 0) known = measured_slowness();
  return large ? known / gain_of_threads() : known;
}

}  // namespace umbilic
