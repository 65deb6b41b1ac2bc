// SPDX-License-Identifier: MIT
/// \file
/// What the parts of a level take, each measured alone.
#pragma once

#include <ctime>

#include "cage/cage.h"
#include "driver/level_work.h"

namespace umbilic {

/// CPU seconds, so that what else the machine does leaves them alone: the best of several rounds.
template <class Work>
double cpu_seconds(const Work& work, double budget = 0.15, int rounds = 2) {
  double best = 1e300, total = 0;
  for (int i = 0; i < rounds || total < budget; ++i) {
    const std::clock_t begin = std::clock();
    work();
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    best = std::min(best, seconds);
    total += seconds + 1e-6;
  }
  return best;
}

/// CPU seconds of one thread, by the rules that a run begins with.
struct LevelParts {
  LevelSize size;
  double refining = 0;       ///< from the cage
  double layout = 0;         ///< patches, caps and tables
  double evaluation = 0;     ///< energy and gradient
  double report = 0;         ///< all energies by the reporting rule
  double assembly = 0;       ///< of the Hessian
  double factorization = 0;  ///< of the Hessian metric's matrix
  double solution = 0;       ///< with it
  double sobolev = 0;        ///< the Sobolev metric, assembled and factored
  double evaluation_flops = 0, factorization_flops = 0;
};

LevelParts measure_parts(const Cage& cage, bool symmetric, int level, const Weights& weights);

}  // namespace umbilic
