// SPDX-License-Identifier: MIT
/// \file
/// What a run will take, in words and as a table.
#pragma once

#include <string>

#include "problem/estimate.h"

namespace umbilic::cli {

/// A duration that is only known roughly: "a second", "about 8 s", "about 20 s", "about 3 min", "about 2 h".
std::string rough_duration(double seconds);

/// The levels of a run with what each will take, and all of them.
std::string estimate_table(const Estimate& estimate);

/// What to know before a run begins that takes more than two minutes, or more memory than the machine has: a line each;
/// empty otherwise.
std::string estimate_warnings(const Estimate& estimate);
/// The same for a machine of this memory, in bytes.
std::string estimate_warnings(const Estimate& estimate, double memory);

}  // namespace umbilic::cli
