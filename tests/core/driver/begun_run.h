// SPDX-License-Identifier: MIT
/// \file
/// Runs as the tests of new targets begin and end them.
#pragma once

#include "driver/run.h"

namespace umbilic {

inline Run begun(const Cage& cage, const RunOptions& options, const Constraints& constraints = {}) {
  return *Run::create(cage, options, constraints);
}

/// Goes on to the end. Returns the energy of the last level.
inline double ended(Run& run) {
  while (!run.step(1000)) {
  }
  return run.levels().back().energy;
}

}  // namespace umbilic
