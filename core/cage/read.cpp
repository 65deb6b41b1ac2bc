// SPDX-License-Identifier: MIT
/// \file
/// Recognizes the format and validates what was read.
#include "cage/read.h"

#include <fmt/format.h>

#include <algorithm>

#include "cage/formats.h"

namespace umbilic {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

int line_of(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position);
  int line = 1;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool crlf = before[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (before[i] == '\n' || (before[i] == '\r' && !crlf)) ++line;
  }
  return line;
}

}  // namespace

Result<CheckedCage> read_checked_cage(std::string_view text, const ReadLimits& limits) {
  if (text.size() > limits.bytes) return Error{fmt::format("the file has more than {} bytes", limits.bytes)};
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) text.remove_prefix(kByteOrderMark.size());
  if (text.find_first_not_of(" \t\v\f\r\n") == std::string_view::npos) return Error{"the file is empty"};

  // Binary OFF must be recognized by its first line, before its bytes are read as text.
  auto file = is_off(text) ? parse_off(text, limits) : parse_obj(text, limits);
  if (const std::size_t zero = text.find('\0'); !file && zero != std::string_view::npos && !is_off(text)) {
    return Error{fmt::format("line {}: not a text file: it holds a zero byte", line_of(text, zero))};
  }
  if (!file) return file.error();
  auto report = validate(file->cage, file->source);
  if (!report) return report.error();
  report->notes.insert(report->notes.begin(), file->notes.begin(), file->notes.end());
  return CheckedCage{std::move(file->cage), std::move(*report)};
}

Result<Cage> read_cage(std::string_view text) {
  auto checked = read_checked_cage(text);
  if (!checked) return checked.error();
  return std::move(checked->cage);
}

}  // namespace umbilic
