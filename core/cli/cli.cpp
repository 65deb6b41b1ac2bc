// SPDX-License-Identifier: MIT
/// \file
/// The outer layer of the command line: help, version, and error handling.
#include "cli/cli.h"

#include <csignal>
#include <new>
#include <stdexcept>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/version.h"

namespace umbilic::cli {

int run_command_line(int argc, const char* const* argv) {
  CLI::App app("umbilic: surfaces that minimize curvature energies, from Catmull-Clark control cages", "umbilic");
  app.set_version_flag("--version", fmt::format("umbilic {}", version()), "Print the version and exit");
  app.set_help_flag("-h,--help", "Print help and exit; every command has its own");
  app.get_formatter()->column_width(32);
  app.require_subcommand(0, 1);  // so that the error names a misspelt command
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return fmt::format("umbilic: {}\nRun with --help for more information.\n", printable_lines(error.what()));
  });
  app.footer(
      "CAGE is an OBJ, OFF or PLY file of a polygon mesh, closed or open, or - for standard input.\n"
      "Exit codes: 0 ended with a result, 1 check-gradient or catalog --check found a mismatch, 2 bad usage,\n"
      "3 bad input, 4 cannot write, 5 the energies are not the surface's (evaluate, optimize), 6 out of memory,\n"
      "130 interrupted, with what there was written.");
  // Reaching a file-size limit, and writing where nobody reads any more, become failed writes.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  int exit_code = kEnded;
  add_instruction_set_option(app);
  add_cage_command(app, exit_code);
  add_info_command(app, exit_code);
  add_evaluate_command(app, exit_code);
  add_optimize_command(app, exit_code);
  add_check_gradient_command(app, exit_code);
  add_torus_command(app, exit_code);
  add_catalog_command(app, exit_code);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) throw CLI::RequiredError("A command");
  } catch (const CLI::ParseError& error) {
    const bool asked_for = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);  // --help, --version
    app.exit(error);
    return asked_for ? kEnded : kBadUsage;
  } catch (const std::bad_alloc&) {
    return fail(kOutOfMemory, "out of memory");
  } catch (const std::length_error&) {  // of a container that could not be addressed
    return fail(kOutOfMemory, "out of memory");
  }
  return exit_code;
}

}  // namespace umbilic::cli
