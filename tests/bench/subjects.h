// SPDX-License-Identifier: MIT
/// \file
/// What the benchmark measures, each as a JSON array, on the genus-2 flag frame.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "cage/generate.h"
#include "driver/surface.h"

namespace umbilic {

constexpr int kThroughputLevel = 3;

/// Without symmetry: every patch is evaluated.
inline RefinedCage genus_two(int level) { return *refine_to_evaluable(*generate_cage("two-3"), level, false); }

inline Weights only(int functional) {
  Weights weights{};
  weights[functional] = 1;
  return weights;
}

inline std::string joined(const std::vector<std::string>& parts) { return fmt::format("[{}]", fmt::join(parts, ",")); }

/// Floating-point operations per second at best, for every instruction set.
std::string peaks();

/// Samples per second of energy and gradient, capped patches included, for every instruction set.
std::string throughput();

/// Seconds of each thing that a level does once, beside one evaluation.
std::string phases();

/// Errors of rules on surfaces that were minimized by the rule in use, which exploits its errors.
std::string quadrature();

}  // namespace umbilic
