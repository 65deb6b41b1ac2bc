// SPDX-License-Identifier: MIT
/// \file
/// Files of the command line: "-" means standard input or output, and a failed write never damages an existing file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cage/cage.h"

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

/// Replaces the file at `path` in one step: writes a new file next to it and renames that. Devices and pipes are
/// written directly.
std::optional<Error> write_file(const std::string& path, std::string_view text);

/// Whether both are the same file, or both are "-". Devices never count as the same.
bool same_output(const std::string& a, const std::string& b);

}  // namespace umbilic::cli
