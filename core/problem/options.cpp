// SPDX-License-Identifier: MIT
/// \file
/// Checks the ranges.
#include "problem/options.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "problem/problem.h"

namespace umbilic {

bool in_range(const RunOptions& options, Error& error) {
  if (!usable(options.weights, error)) return false;
  if (options.first_level < 0) {
    error.message = fmt::format("levels[0]: {} is negative", options.first_level);
  } else if (options.last_level < options.first_level) {
    error.message = fmt::format("levels[1]: {} is below levels[0], {}", options.last_level, options.first_level);
  } else if (options.cap_rings < 1 || options.cap_rings > kMostCapRings ||
             !std::has_single_bit(static_cast<unsigned>(options.cap_rings))) {
    error.message = fmt::format("cap_rings: {} is none of 1, 2, 4, 8, 16", options.cap_rings);
  } else if (options.max_iterations < 0) {
    error.message = fmt::format("max_iterations: {} is negative", options.max_iterations);
  } else if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    error.message = fmt::format("tolerance: {} is not a finite number >= 0", options.tolerance);
  } else if (options.accuracy && !(*options.accuracy > 0 && *options.accuracy < 1)) {
    error.message = fmt::format("accuracy: {} is not between 0 and 1", *options.accuracy);
  }
  return error.message.empty();
}

bool in_range(const SurfaceState& state, Error& error) {
  if (state.level < 0) error.message = fmt::format("level: {} is negative", state.level);
  return error.message.empty();
}

}  // namespace umbilic
