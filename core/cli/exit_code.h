// SPDX-License-Identifier: MIT
/// \file
/// What the program tells the shell.
#pragma once

namespace umbilic::cli {

enum ExitCode {
  kEnded = 0,        ///< with a result, also when the run was interrupted
  kMismatch = 1,     ///< check-gradient and catalog --check only: numbers disagree
  kBadUsage = 2,     ///< the command line makes no sense
  kBadInput = 3,     ///< the cage cannot be read, or not be used as asked
  kCannotWrite = 4,  ///< a result could not be written
};

}  // namespace umbilic::cli
