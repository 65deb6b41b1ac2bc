// SPDX-License-Identifier: MIT
/// \file
/// Problems from files: a problem, a report whose run is continued, or only a cage.
#pragma once

#include <string>

#include "problem/problem.h"

namespace umbilic::cli {

struct ProblemFile {
  Problem problem;       ///< its cage is generated or a text, never a path
  std::string cage;      ///< the cage's name in messages
  bool complete = true;  ///< false for a file with only a cage; the problem then has no terms
};

/// Reads the file at `path`, or standard input for "-". A file that begins with { is a problem or a report, any other
/// is a cage. The path of a problem's cage is relative to the problem's folder. Errors begin with the file's name.
Result<ProblemFile> load_problem(const std::string& path);

}  // namespace umbilic::cli
