// SPDX-License-Identifier: MIT
/// \file
/// The program `umbilic`: parses the command line and runs one command.
#pragma once

namespace umbilic::cli {

/// Returns the exit code. Results go to standard output and files, everything else to standard error.
int run_command_line(int argc, const char* const* argv);

}  // namespace umbilic::cli
