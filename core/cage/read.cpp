// SPDX-License-Identifier: MIT
/// \file
/// Recognizes the format and validates what was read.
#include "cage/read.h"

#include <fmt/format.h>

#include <algorithm>

#include "cage/formats.h"
#include "cage/ply_header.h"
#include "cage/write.h"

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

/// The file behind its byte-order mark.
std::string_view without_mark(std::string_view file) {
  if (file.starts_with(kByteOrderMark)) file.remove_prefix(kByteOrderMark.size());
  return file;
}

/// The polygons, before they are validated.
Result<PolygonFile> parse_polygons(std::string_view file, const ReadLimits& limits) {
  if (file.size() > limits.bytes) return Error{fmt::format("the file has more than {} bytes", limits.bytes)};
  file = without_mark(file);
  if (file.find_first_not_of(" \t\v\f\r\n") == std::string_view::npos) return Error{"the file is empty"};

  if (is_ply(file)) return parse_ply(file, limits);
  // Binary OFF must be recognized by its first line, before its bytes are read as text.
  if (is_off(file)) return parse_off(file, limits);
  auto polygons = parse_obj(file, limits);
  if (const std::size_t zero = file.find('\0'); !polygons && zero != std::string_view::npos) {
    return Error{fmt::format("line {}: not a text file: it holds a zero byte", line_of(file, zero))};
  }
  return polygons;
}

}  // namespace

Result<CheckedCage> read_checked_cage(std::string_view file, const ReadLimits& limits) {
  auto polygons = parse_polygons(file, limits);
  if (!polygons) return polygons.error();
  auto report = validate(polygons->cage, polygons->source);
  if (!report) return report.error();
  report->notes.insert(report->notes.begin(), polygons->notes.begin(), polygons->notes.end());
  return CheckedCage{std::move(polygons->cage), std::move(*report)};
}

Result<Cage> read_cage(std::string_view file) {
  auto checked = read_checked_cage(file);
  if (!checked) return checked.error();
  return std::move(checked->cage);
}

Result<std::string> cage_text(std::string_view file) {
  if (!is_ply(without_mark(file))) return std::string(file);
  const auto header = parse_ply_header(without_mark(file));
  if (header && header->format == PlyFormat::kAscii) return std::string(file);
  const auto polygons = parse_polygons(file, {});
  if (!polygons) return polygons.error();
  Cage validated = polygons->cage;
  if (auto report = validate(validated, polygons->source); !report) return report.error();
  return write_obj(polygons->cage);
}

}  // namespace umbilic
