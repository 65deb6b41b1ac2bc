// SPDX-License-Identifier: MIT
/// \file
/// Writes files by descriptors, those of drafts relative to their folder, so that no path is longer than the target's.
#include "cli/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace umbilic::cli {

namespace {

namespace fs = std::filesystem;

/// Where the system has it, without the right to list the folder.
#ifdef O_PATH
constexpr int kFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;
#else
constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
#endif

/// Names of drafts that others have left are passed over, up to this many.
constexpr int kMostNames = 1000;

}  // namespace

OutputFile OutputFile::draft(const fs::path& target) {
  OutputFile file;
  file.create(target);
  return file;
}

OutputFile OutputFile::in_place(const fs::path& target) {
  OutputFile file;
  file.descriptor_ = open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  file.check(file.is_open());
  return file;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : folder_(std::exchange(other.folder_, -1)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      error_(other.error_),
      name_(std::exchange(other.name_, {})),
      target_name_(std::move(other.target_name_)) {}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!name_.empty()) unlinkat(folder_, name_.c_str(), 0);
  if (folder_ >= 0) close(folder_);
}

bool OutputFile::check(bool succeeded) {
  if (!succeeded && error_ == 0) error_ = errno;
  return succeeded;
}

void OutputFile::create(const fs::path& target) {
  target_name_ = target.filename().string();
  const fs::path folder = target.parent_path();
  folder_ = open(folder.empty() ? "." : folder.c_str(), kFolder);
  if (!check(folder_ >= 0)) return;
  for (int n = 0; n < kMostNames && descriptor_ < 0; ++n) {
    std::string name = fmt::format(".umbilic-{}-{}", getpid(), n);
    descriptor_ = openat(folder_, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor_ >= 0) name_ = std::move(name);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (!check(is_open()) || adopt_permissions(target)) return;
  close(std::exchange(descriptor_, -1));
}

bool OutputFile::adopt_permissions(const fs::path& target) {
  struct stat status {};
  const mode_t mask = umask(0);
  umask(mask);
  const bool exists = stat(target.c_str(), &status) == 0;
  return check(fchmod(descriptor_, exists ? status.st_mode & 07777 : 0666 & ~mask) == 0);
}

bool OutputFile::write(std::string_view text) {
  if (error_ != 0) return false;
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (!check(count >= 0)) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool OutputFile::finish() {
  if (error_ != 0) return false;
  const bool flushed = fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS;  // devices and pipes have no disk
  if (!check(flushed)) return false;
  if (!check(close(std::exchange(descriptor_, -1)) == 0)) return false;
  return name_.empty() || replace();
}

bool OutputFile::replace() {
  if (!check(renameat(folder_, name_.c_str(), folder_, target_name_.c_str()) == 0)) return false;
  name_.clear();
  return true;
}

}  // namespace umbilic::cli
