// SPDX-License-Identifier: MIT
/// \file
/// The levels of runs with an accuracy.
#include "driver/accuracy.h"

#include <algorithm>

#include "driver/memory.h"

namespace umbilic {
namespace {

constexpr double kToleranceShare = 0.02;
/// How many levels an accuracy may take, and how many if these do not even tell a limit: more than three, as energies
/// may begin to converge late.
constexpr int kMostLevels = 6, kMostLevelsWithoutLimit = 5;

}  // namespace

double tolerance_of(const RunOptions& options) {
  return options.accuracy ? std::max(options.tolerance, kToleranceShare * *options.accuracy) : options.tolerance;
}

bool suffice(int levels, const LimitReport& limit, double accuracy) {
  return limit.relative_error() <= accuracy ||
         (levels >= kMostLevelsWithoutLimit && limit.status != LimitStatus::kConverging);
}

void choose_last_level(const RefinedCage& cage, int required, int started, RunOptions& options) {
  const int first = std::max({options.first_level, required, started});
  const auto fits = [&](int level) {
    options.last_level = level;
    return faces_after(cage.mesh, level) <= kMaxFaces && !too_large_a_run(cage, required, options);
  };
  for (int level = first + kMostLevels - 1; level > first && !fits(level); --level) {
  }
}

}  // namespace umbilic
