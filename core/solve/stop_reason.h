// SPDX-License-Identifier: MIT
/// \file
/// Why an optimizer ended. An optimizer does not fail; it ends with one of these.
#pragma once

#include <string_view>

namespace umbilic {

enum class StopReason {
  kConverged,          ///< the decrease still predicted is below the tolerance
  kMaxIterations,      ///< reached the largest number of iterations
  kLineSearchStalled,  ///< no step along the search direction satisfies the strong Wolfe conditions
  kRoundOff,           ///< the decrease still predicted is below the rounding error of the value
  kNotFinite,          ///< the value is not finite at the start
  kDegenerate,         ///< the objective reports that its last point is degenerate
  kCancelled,
  // Not the optimizer's own, but what is found of the point where it ended:
  kBelowBound,   ///< the energy is below what any closed surface has: it is not the surface's
  kNotResolved,  ///< curvature hides between the samples: the energy is not the surface's
};

/// "converged", "max_iterations", "line_search_stalled", "round_off", "not_finite", "degenerate", "cancelled",
/// "below_bound", "not_resolved".
constexpr std::string_view name_of(StopReason reason) {
  switch (reason) {
    case StopReason::kConverged: return "converged";
    case StopReason::kMaxIterations: return "max_iterations";
    case StopReason::kLineSearchStalled: return "line_search_stalled";
    case StopReason::kRoundOff: return "round_off";
    case StopReason::kNotFinite: return "not_finite";
    case StopReason::kDegenerate: return "degenerate";
    case StopReason::kCancelled: return "cancelled";
    case StopReason::kBelowBound: return "below_bound";
    case StopReason::kNotResolved: return "not_resolved";
  }
  return "";
}

}  // namespace umbilic
