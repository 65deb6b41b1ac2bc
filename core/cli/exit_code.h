// SPDX-License-Identifier: MIT
/// \file
/// The exit codes of the program.
#pragma once

namespace umbilic::cli {

enum ExitCode {
  kEnded = 0,        ///< with a result
  kMismatch = 1,     ///< check-gradient and catalog --check only: numbers disagree
  kBadUsage = 2,     ///< the command line is invalid
  kBadInput = 3,     ///< the cage cannot be read, or cannot be used in this way
  kCannotWrite = 4,  ///< a result could not be written
  /// The energies are not finite, or not the surface's: below a bound that holds for every closed surface, or with
  /// curvature hidden between the samples. Everything is written all the same.
  kNotCredible = 5,
  /// The system refused memory: the results that need less are written, if the run itself has come to its end.
  kOutOfMemory = 6,
  /// optimize and catalog: ended by SIGINT, SIGTERM or SIGHUP before their time; what there was is written. As a shell
  /// has it of a program that SIGINT ends.
  kInterrupted = 130,
};

}  // namespace umbilic::cli
