// SPDX-License-Identifier: MIT
/// \file
/// The flags of the command line that change a problem.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <vector>

#include "problem/problem.h"

namespace umbilic::cli {

/// What the flags change, in the order in which they were given.
using ProblemChanges = std::vector<std::function<void(Problem&)>>;

/// Adds the flags to `command`, which fill in `changes`.
void add_problem_options(CLI::App& command, const std::shared_ptr<ProblemChanges>& changes);

}  // namespace umbilic::cli
