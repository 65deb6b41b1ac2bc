// SPDX-License-Identifier: MIT
/// \file
/// What the benchmark measures, each as a JSON array, mostly on the genus-2 flag frame.
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

/// Energies of minimizers by level and by the most rings that caps may take.
std::string caps();

/// A run from its cage to its end: CAGE FUNCTIONAL LAST_LEVEL METRIC symmetric|unsymmetric, as a JSON object; nothing
/// for other arguments.
std::string whole_run(const std::vector<std::string>& arguments);

/// The OBJ text of a cage of cages.h; nothing for other arguments.
std::string cage_text(const std::vector<std::string>& arguments);

/// Seconds of an iteration of L-BFGS beside its evaluations and metric, by unknowns.
std::string overhead();

/// Seconds of an evaluation and of a level's solve, by patches.
std::string scaling();

/// How often per second all threads together do what a level consists of, beside one thread, and beside as many threads
/// that do it each for itself.
std::string threads();

/// CPU seconds of whole runs by what they go into.
std::string shares();

/// CPU seconds of the parts of levels of many kinds, beside those of driver/level_work.h.
std::string rates();

}  // namespace umbilic
