// SPDX-License-Identifier: MIT
/// \file
/// The commands of the program, each in its own file.
#pragma once

#include <CLI/CLI.hpp>

namespace umbilic::cli {

/// Each function adds its command to `app`. If the command line names it, parsing runs it and sets `exit_code`.
void add_cage_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_evaluate_command(CLI::App& app, int& exit_code);
void add_optimize_command(CLI::App& app, int& exit_code);
void add_check_gradient_command(CLI::App& app, int& exit_code);
void add_torus_command(CLI::App& app, int& exit_code);
void add_catalog_command(CLI::App& app, int& exit_code);

}  // namespace umbilic::cli
