// SPDX-License-Identifier: MIT
/// \file
/// The program's output to the terminal: results, errors, and a progress line.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <string_view>

#include "catalog/runner.h"

namespace umbilic::cli {

/// `text` with '?' for all that would do something to a terminal but end its lines: names of files and arguments may
/// hold anything.
std::string printable_lines(std::string_view text);

/// Prints "umbilic: message", made printable, to standard error and returns `exit_code`.
int fail(int exit_code, std::string_view message);

/// Prints a text, if there is any, to standard error.
void tell(std::string_view text);

/// Prints a result to standard output; false, with a message, when that cannot be written.
bool print(std::string_view text);

/// Progress of a run on standard error: a line that is updated if standard error is a terminal, else a line per level.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  /// Clears the line.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Cheap enough to call after every unit of work.
  void update(const Run& run);

 private:
  void clear();

  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  std::size_t levels_told_ = 0;
  std::chrono::steady_clock::time_point next_update_{};
};

/// Progress of a catalog on standard error: a bar if that is a terminal, else a line per entry.
class CatalogBar {
 public:
  explicit CatalogBar(bool quiet);
  /// Clears the line.
  ~CatalogBar();
  CatalogBar(const CatalogBar&) = delete;
  CatalogBar& operator=(const CatalogBar&) = delete;

  /// Cheap enough to call after every unit of work, by one thread at a time.
  void update(const catalog::CatalogProgress& progress);

 private:
  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  std::size_t told_ = 0;
  std::chrono::steady_clock::time_point next_update_{};
};

}  // namespace umbilic::cli
