// SPDX-License-Identifier: MIT
/// \file
/// Problems from files: of a problem, of a report that goes on where it ended, or of a cage alone.
#pragma once

#include <string>

#include "problem/problem.h"

namespace umbilic::cli {

struct ProblemFile {
  Problem problem;       ///< its cage generated or as text, never a path
  std::string cage;      ///< what messages call the cage
  bool complete = true;  ///< false for a cage alone, whose problem has no terms yet
};

/// Reads the file at `path`, or standard input for "-": a problem or a report where it begins with {, else a cage. A
/// cage's path in a problem counts from the problem's folder. Errors begin with the file's name.
Result<ProblemFile> load_problem(const std::string& path);

}  // namespace umbilic::cli
