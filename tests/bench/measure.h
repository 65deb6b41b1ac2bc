// SPDX-License-Identifier: MIT
/// \file
/// The seconds that a piece of work takes, as the best of several rounds on a noisy machine.
#pragma once

#include <algorithm>
#include <chrono>

namespace umbilic {

/// The shortest round of several that fill `budget` seconds; `work` runs at least `rounds` times.
template <class Work>
double best_seconds(const Work& work, double budget = 0.5, int rounds = 3) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300, total = 0;
  for (int i = 0; i < rounds || total < budget; ++i) {
    const auto begin = Clock::now();
    work();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    best = std::min(best, seconds);
    total += seconds;
  }
  return best;
}

}  // namespace umbilic
