// SPDX-License-Identifier: MIT
/// \file
/// The entry of the program `umbilic`.
#include "cli/cli.h"

int main(int argc, char** argv) { return umbilic::cli::run_command_line(argc, argv); }
