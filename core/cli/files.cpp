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
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#include "cage/read.h"
#include "cli/console.h"

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

/// A new file next to `target`, open for writing; deleted again unless it is renamed.
class Draft {
 public:
  explicit Draft(const fs::path& target) : name_(target.string() + ".XXXXXX"), descriptor_(mkstemp(name_.data())) {}
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!name_.empty()) unlink(name_.c_str());
  }

  bool is_open() {
    if (descriptor_ < 0) name_.clear();
    return descriptor_ >= 0;
  }

  /// Gives the file the permissions of the one that it replaces, or those of a new file.
  bool adopt_permissions(const fs::path& target) {
    struct stat status {};
    const mode_t mask = umask(0);
    umask(mask);
    const bool exists = stat(target.c_str(), &status) == 0;
    return fchmod(descriptor_, exists ? status.st_mode & 07777 : 0666 & ~mask) == 0;
  }

  bool write_all(std::string_view text) {
    while (!text.empty()) {
      const ssize_t count = write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return false;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    return fsync(descriptor_) == 0;
  }

  bool rename_to(const fs::path& target) {
    if (std::rename(name_.c_str(), target.c_str()) != 0) return false;
    name_.clear();
    return true;
  }

 private:
  std::string name_;
  int descriptor_;
};

/// Devices, pipes and sockets cannot be replaced.
bool is_special(const fs::path& target) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::optional<Error> write_directly(const std::string& path, std::string_view text) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return cannot_write(path, reason());
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
  const std::string why = reason();
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) return cannot_write(path, written ? reason() : why);
  return std::nullopt;
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
  const fs::path target = target_of(path);
  std::error_code error;
  if (path.empty()) return cannot_write("''", std::strerror(ENOENT));
  if (fs::is_directory(target, error)) return cannot_write(path, std::strerror(EISDIR));
  if (fs::exists(target, error) && access(target.c_str(), W_OK) != 0) return cannot_write(path, reason());
  if (is_special(target)) return std::nullopt;
  if (!Draft(target).is_open()) return cannot_write(path, reason());
  return std::nullopt;
}

std::optional<Error> write_file(const std::string& path, std::string_view text) {
  if (path == "-") {
    if (!print(text)) return Error{"a result is lost"};
    return std::nullopt;
  }
  const fs::path target = target_of(path);
  if (is_special(target)) return write_directly(path, text);
  if (auto error = check_writable(path)) return error;
  Draft draft(target);
  const bool replaced =
      draft.is_open() && draft.adopt_permissions(target) && draft.write_all(text) && draft.rename_to(target);
  if (!replaced) return cannot_write(path, reason());
  return std::nullopt;
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
