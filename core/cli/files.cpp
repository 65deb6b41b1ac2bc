// SPDX-License-Identifier: MIT
/// \file
/// Reads complete files, and replaces them safely (POSIX).
#include "cli/files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "cage/read.h"
#include "cli/console.h"
#include "cli/output_file.h"

namespace umbilic::cli {

namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

Error cannot_write(const std::string& path, const std::string& why) {
  return Error{fmt::format("cannot write {}: {}", path, why)};
}

/// The file to which `path` leads through symbolic links, even if it does not exist.
fs::path target_of(const std::string& path) {
  fs::path target = path;
  std::error_code error;
  constexpr int kMostLinks = 40;
  for (int links = 0; links < kMostLinks && fs::is_symlink(target, error); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

/// Devices, pipes and sockets cannot be replaced.
bool is_special(const fs::path& target) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Error cannot_write(const std::string& path, int error) { return cannot_write(path, std::strerror(error)); }

/// Whether the system forbids a new file in the folder, or that one takes the place of the old one: the folder may not
/// be written, the file is another user's in a folder like /tmp, or it is a mount point.
bool forbids_replacing(int error) { return error == EACCES || error == EPERM || error == EROFS || error == EBUSY; }

/// Whether all of the source's text has been written to the open output.
bool write_all(OutputFile& output, const TextSource& source) {
  return source([&](std::string_view piece) { return output.write(piece); });
}

std::optional<Error> write_in_place(const std::string& path, const fs::path& target, const TextSource& source) {
  OutputFile output = OutputFile::in_place(target);
  if (!output.is_open()) return cannot_write(path, output.error());
  if (write_all(output, source) && output.finish()) return std::nullopt;
  const std::string lost = is_special(target) ? "" : "; what was there is lost, since its folder cannot be written";
  return cannot_write(path, std::strerror(output.error()) + lost);
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t most_bytes) {
  const bool from_stdin = path == "-";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      from_stdin ? stdin : std::fopen(path.c_str(), "rb"),
      [](std::FILE* f) { return f == stdin ? 0 : std::fclose(f); });
  if (!file) return Error{fmt::format("cannot read {}: {}", path, reason())};
  std::string text;
  std::array<char, 1 << 16> block;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    if (count > most_bytes - text.size()) {
      return Error{
          fmt::format("cannot read {}: it has more than {} bytes", from_stdin ? "standard input" : path, most_bytes)};
    }
    text.append(block.data(), count);
  }
  if (std::ferror(file.get())) {
    return Error{fmt::format("cannot read {}: {}", from_stdin ? "standard input" : path, reason())};
  }
  return text;
}

Result<CageFile> load_cage(const std::string& path) {
  const std::string name = path == "-" ? "standard input" : path;
  const auto text = read_file(path, ReadLimits{}.bytes);
  if (!text) return text.error();
  auto checked = read_checked_cage(*text);
  if (!checked) return Error{fmt::format("{}: {}", name, checked.error().message)};
  return CageFile{name, std::move(checked->cage), std::move(checked->report)};
}

std::optional<Error> check_writable(const std::string& path) {
  if (path == "-") return std::nullopt;
  if (path.empty()) return cannot_write("''", ENOENT);
  const fs::path target = target_of(path);
  struct stat status {};
  const bool exists = stat(target.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) return cannot_write(path, errno);
  if (exists && S_ISDIR(status.st_mode)) return cannot_write(path, EISDIR);
  if (exists && access(target.c_str(), W_OK) != 0) return cannot_write(path, errno);
  if (is_special(target)) return std::nullopt;
  const OutputFile draft = OutputFile::draft(target);
  if (!draft.is_open() && !(exists && forbids_replacing(draft.error()))) return cannot_write(path, draft.error());
  return std::nullopt;
}

std::optional<Error> write_file(const std::string& path, const TextSource& source) {
  if (path == "-") {
    if (!source(print)) return Error{"a result is lost"};
    return std::nullopt;
  }
  if (auto error = check_writable(path)) return error;
  const fs::path target = target_of(path);
  if (is_special(target)) return write_in_place(path, target, source);
  OutputFile draft = OutputFile::draft(target);
  if (draft.is_open() && write_all(draft, source) && draft.finish()) return std::nullopt;
  std::error_code error;
  if (forbids_replacing(draft.error()) && fs::exists(target, error)) return write_in_place(path, target, source);
  return cannot_write(path, draft.error());
}

std::optional<Error> write_file(const std::string& path, std::string_view text) {
  return write_file(path, [text](const TextSink& take) { return take(text); });
}

bool same_output(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") return a == b;
  std::error_code error;
  const fs::path first = fs::weakly_canonical(fs::absolute(target_of(a)), error);
  const fs::path second = fs::weakly_canonical(fs::absolute(target_of(b)), error);
  if (is_special(first)) return false;
  return first == second || fs::equivalent(first, second, error);
}

}  // namespace umbilic::cli
