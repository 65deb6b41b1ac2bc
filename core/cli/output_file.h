// SPDX-License-Identifier: MIT
/// \file
/// A file that is written piece by piece, as a draft that then takes the place of the old file, or in place (POSIX).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace umbilic::cli {

/// An open output, or the reason why it is not open. A draft is a new file in the target's folder with a short name, so
/// that the target's own name may be as long as the system allows; it is deleted again unless `finish` succeeds. So
/// there is the old file or the whole new one, whatever fails.
class OutputFile {
 public:
  /// Begins a draft with the permissions of the file that it is to replace, or those of a new file.
  static OutputFile draft(const std::filesystem::path& target);

  /// Opens and empties the file, which is created if need be; or opens a device or pipe.
  static OutputFile in_place(const std::filesystem::path& target);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  bool is_open() const { return descriptor_ >= 0; }

  /// The `errno` of what failed first; 0 if nothing has.
  int error() const { return error_; }

  /// Whether all of `text` was written.
  bool write(std::string_view text);

  /// Brings what was written to the disk, closes the file and, if it is a draft, puts it in the place of its target.
  /// Nothing can be written after that.
  bool finish();

 private:
  OutputFile() = default;
  void create(const std::filesystem::path& target);
  bool adopt_permissions(const std::filesystem::path& target);
  bool replace();

  /// Returns `succeeded`, and keeps `errno` if that is false.
  bool check(bool succeeded);

  int folder_ = -1;      // of a draft
  int descriptor_ = -1;  // -1 before it is open and after it is closed
  int error_ = 0;
  std::string name_;         // of the draft in its folder; empty if there is none
  std::string target_name_;  // in the same folder
};

}  // namespace umbilic::cli
