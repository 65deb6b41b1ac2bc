// SPDX-License-Identifier: MIT
/// \file
/// Reads OFF and its variants with more numbers per vertex: one vertex and one face per line; additional numbers are
/// ignored.
#include <fmt/format.h>

#include <algorithm>

#include "cage/formats.h"
#include "cage/text.h"

namespace umbilic {

namespace {

constexpr std::string_view kOff = "OFF";

/// "OFF" with the prefixes ST, C, N, 4 and n of the variants. Files in which the counts follow the keyword without a
/// blank ("OFF490 518 0") are common.
bool is_keyword(std::string_view word) {
  const std::size_t off = word.find(kOff);
  if (off == std::string_view::npos || off > 5) return false;
  if (word.substr(0, off).find_first_not_of("STCN4n") != std::string_view::npos) return false;
  return word.find_first_not_of("0123456789", off + kOff.size()) == std::string_view::npos;
}

/// The next line that has more than blanks and a comment.
std::optional<Line> next_content(LineReader& lines) {
  while (auto line = lines.next()) {
    line->text = without_comment(line->text);
    std::string_view words = line->text;
    if (!take_word(words).empty()) return line;
  }
  return std::nullopt;
}

struct Counts {
  long long vertices = 0;
  long long faces = 0;
  int line = 0;
};

Result<Counts> parse_counts(const Line& line) {
  std::string_view words = line.text;
  Counts counts;
  counts.line = line.number;
  for (long long* count : {&counts.vertices, &counts.faces}) {
    const std::string_view word = take_word(words);
    const auto number = parse_integer(word);
    if (!number || *number < 0) {
      return Error{
          fmt::format("line {}: expected the numbers of vertices and faces, found {}", line.number, in_quotes(word))};
    }
    *count = *number;
  }
  return counts;
}

/// Reads the keyword; the counts may follow on the same line.
Result<Counts> parse_header(LineReader& lines) {
  auto line = next_content(lines);
  std::string_view words = line ? line->text : std::string_view{};
  const std::string_view keyword = take_word(words);
  const std::size_t off = keyword.find(kOff);
  if (keyword.substr(0, off).find_first_of("4n") != std::string_view::npos) {
    return Error{fmt::format("line {}: {} has vertices of another dimension than 3", line->number, keyword)};
  }
  std::string_view peek = words;
  if (take_word(peek) == "BINARY")
    return Error{fmt::format("line {}: binary OFF is not read; save it as text", line->number)};
  line->text.remove_prefix(static_cast<std::size_t>(keyword.data() - line->text.data()) + off + kOff.size());
  peek = line->text;
  if (take_word(peek).empty()) line = next_content(lines);
  if (!line)
    return Error{fmt::format("line {}: the file ends before the numbers of vertices and faces", lines.number())};
  return parse_counts(*line);
}

Result<std::vector<int>> parse_face(std::string_view words, long long vertex_count, int most) {
  const std::string_view first = take_word(words);
  const auto size = parse_integer(first);
  if (!size || *size < 0) return Error{fmt::format("expected a face's number of vertices, found {}", in_quotes(first))};
  if (*size > most) return Error{fmt::format("a face of more than {} vertices", most)};
  std::vector<int> face;
  for (long long corner = 0; corner < *size; ++corner) {
    const std::string_view word = take_word(words);
    if (word.empty()) return Error{fmt::format("a face of {} vertices has only {}", *size, corner)};
    const auto index = parse_integer(word);
    if (!index) return Error{fmt::format("{} is not a vertex index", in_quotes(word))};
    if (*index < 0 || *index >= vertex_count) {
      return Error{fmt::format("index {} does not exist: {} vertices have the indices 0 to {}", *index, vertex_count,
                               vertex_count - 1)};
    }
    face.push_back(static_cast<int>(*index));
  }
  return face;
}

Error truncated(const LineReader& lines, long long found, long long expected, std::string_view what,
                const Counts& counts) {
  return Error{fmt::format("line {}: the file ends after {} of the {} {} that line {} announces", lines.number(), found,
                           expected, what, counts.line)};
}

}  // namespace

bool is_off(std::string_view text) {
  LineReader lines(text);
  const auto line = next_content(lines);
  std::string_view words = line ? line->text : std::string_view{};
  return is_keyword(take_word(words));
}

Result<PolygonFile> parse_off(std::string_view text, const ReadLimits& limits) {
  LineReader lines(text);
  const auto counts = parse_header(lines);
  if (!counts) return counts.error();
  if (counts->vertices > limits.vertices || counts->faces > limits.faces) {
    return Error{fmt::format("line {}: {} vertices and {} faces: at most {} and {} are read", counts->line,
                             counts->vertices, counts->faces, limits.vertices, limits.faces)};
  }

  PolygonFile file;
  file.source.first_index = 0;
  VertexList vertices(limits.vertices);
  while (vertices.size() < counts->vertices) {
    auto line = next_content(lines);
    if (!line) return truncated(lines, vertices.size(), counts->vertices, "vertices", *counts);
    const auto position = vertices.append(line->text);
    if (!position) return Error{fmt::format("line {}: {}", line->number, position.error().message)};
    file.source.vertex_lines.push_back(line->number);
  }
  while (static_cast<long long>(file.cage.faces.size()) < counts->faces) {
    const auto line = next_content(lines);
    if (!line) return truncated(lines, static_cast<long long>(file.cage.faces.size()), counts->faces, "faces", *counts);
    auto face = parse_face(line->text, counts->vertices, limits.face_size);
    if (!face) return Error{fmt::format("line {}: {}", line->number, face.error().message)};
    file.cage.faces.push_back(std::move(*face));
    file.source.face_lines.push_back(line->number);
  }
  if (const auto line = next_content(lines)) {
    return Error{fmt::format("line {}: more lines than the {} vertices and {} faces that line {} announces",
                             line->number, counts->vertices, counts->faces, counts->line)};
  }
  file.cage.vertices = vertices.points();
  return file;
}

}  // namespace umbilic
