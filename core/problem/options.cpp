// SPDX-License-Identifier: MIT
/// \file
/// The ranges of the options.
#include "problem/options.h"

#include <fmt/format.h>

#include <cmath>

namespace umbilic {

bool in_range(const RunOptions& options, Error& error) {
  if (!usable(options.weights, error)) return false;
  if (options.first_level < 0 || options.last_level < options.first_level) {
    error.message = fmt::format("levels {}..{}: expected 0 <= first <= last", options.first_level, options.last_level);
  } else if (options.max_iterations < 0) {
    error.message = fmt::format("{} iterations: expected a number >= 0", options.max_iterations);
  } else if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    error.message = fmt::format("tolerance {}: expected a finite number >= 0", options.tolerance);
  }
  return error.message.empty();
}

}  // namespace umbilic
