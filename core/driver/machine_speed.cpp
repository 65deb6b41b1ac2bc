// SPDX-License-Identifier: MIT
/// \file
/// Times evaluations of one energy.
#include "driver/machine_speed.h"

#include <algorithm>
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

/// The best of several rounds, each of which all threads share.
double measured_slowness() {
  constexpr double kEnoughSeconds = 4e-3;
  constexpr int kFewest = 3, kMost = 100;
  Weights weights{};
  weights[kMvsCross] = 1;
  RefinedCage cage = *refine_to_evaluable(*generate_cage("torus"), 1, false);
  const Points control = cage.control;
  const Surface surface(std::move(cage), CapKind::kSmooth, weights);
  const LevelSize size = level_size(1, 1, surface.layout(), 0, surface.symmetry().order, 0);
  Points gradient;
  double best = 1e300, total = 0;
  for (int round = 0; round < kFewest || (total < kEnoughSeconds && round < kMost); ++round) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    surface.energy().evaluate(control, &gradient);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    best = std::min(best, seconds);
    total += seconds;
  }
  const double slowness = best / level_work(size, weights, MetricChoice::kIdentity).energy;
  return std::isfinite(slowness) && slowness > 0 ? slowness : 1;
}

}  // namespace

double machine_slowness(bool large) {
  static std::mutex mutex;
  static InstructionSet set{};
  static int threads = 0;
  static double slowness = 1;
  const std::lock_guard lock(mutex);
  if (threads != thread_count() || set != instruction_set()) {
    slowness = measured_slowness();
    threads = thread_count();
    set = instruction_set();
  }
  return large ? slowness : slowness * gain_of_threads();
}

}  // namespace umbilic
