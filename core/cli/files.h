// SPDX-License-Identifier: MIT
/// \file
/// Files of the command line: "-" means standard input or output, and a failed write does not damage an existing file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "cage/cage.h"
#include "cage/write.h"

namespace umbilic::cli {

/// A cage with its name for messages.
struct CageFile {
  std::string name;
  Cage cage;
  CageReport report;
};

/// The whole text at `path`, which is refused as soon as it turns out to have more than `most_bytes`.
Result<std::string> read_file(const std::string& path, std::size_t most_bytes = std::size_t{1} << 28);

/// Reads and validates the cage at `path`; errors begin with its name.
Result<CageFile> load_cage(const std::string& path);

/// Why `path` will not be writable later, if that can be determined now. Leaves nothing behind.
std::optional<Error> check_writable(const std::string& path);

/// Hands a text to a sink piece by piece, the same text in each call; returns whether the sink took all of it.
using TextSource = std::function<bool(const TextSink&)>;

/// Replaces the file at `path` in one step (cli/output_file.h). Written in place, so that a failed write loses what was
/// there, are devices and pipes, and files that may be written in a folder that may not.
std::optional<Error> write_file(const std::string& path, const TextSource& source);
std::optional<Error> write_file(const std::string& path, std::string_view text);

/// Whether both are the same file, or both are "-". Devices never count as the same.
bool same_output(const std::string& a, const std::string& b);

}  // namespace umbilic::cli
