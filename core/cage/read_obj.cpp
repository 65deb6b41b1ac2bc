// SPDX-License-Identifier: MIT
/// \file
/// Reads the statements `v`, `f`, `g` and `o` of OBJ, and counts `t`; no other statement concerns the control mesh.
#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cage/formats.h"
#include "cage/text.h"

namespace umbilic {

namespace {

/// Statements of an OBJ text: lines without comments, joined where a line ends with a backslash.
class Statements {
 public:
  explicit Statements(std::string_view text) : lines_(text) {}

  /// The next statement, numbered by its first line; valid until the next call.
  std::optional<Line> next() {
    const auto line = lines_.next();
    if (!line) return std::nullopt;
    std::string_view part = without_comment(line->text);
    if (part.empty() || part.back() != '\\') return Line{part, line->number};
    joined_.clear();
    while (!part.empty() && part.back() == '\\') {
      joined_.append(part.substr(0, part.size() - 1)).append(" ");
      const auto more = lines_.next();
      part = more ? without_comment(more->text) : std::string_view{};
    }
    joined_.append(part);
    return Line{joined_, line->number};
  }

 private:
  LineReader lines_;
  std::string joined_;
};

/// Whether `tail` is what may follow the vertex in a corner: "", "/t", "//n" or "/t/n".
bool is_corner_tail(std::string_view tail) {
  if (tail.empty()) return true;
  tail.remove_prefix(1);
  const std::size_t slash = tail.find('/');
  const std::string_view texture = tail.substr(0, slash);
  if (!texture.empty() && !parse_integer(texture)) return false;
  if (slash == std::string_view::npos) return true;
  const std::string_view normal = tail.substr(slash + 1);
  return normal.empty() || parse_integer(normal);
}

/// The zero-based index of the vertex that a corner names, given that `known` vertices have been read so far. Positive
/// indices may refer to later vertices, so validation checks their upper bound.
Result<int> parse_corner(std::string_view word, int known) {
  const std::size_t slash = word.find('/');
  const auto index = parse_integer(word.substr(0, slash));
  if (!index || !is_corner_tail(slash == std::string_view::npos ? std::string_view{} : word.substr(slash))) {
    return Error{fmt::format("{} is not a face corner (v, v/vt, v//vn or v/vt/vn)", in_quotes(word))};
  }
  if (*index == 0) return Error{"vertex 0 does not exist: indices start at 1"};
  if (*index < -static_cast<long long>(known)) {
    return Error{fmt::format("vertex {} does not exist: {} come before this line", *index, known)};
  }
  if (*index < 0) return static_cast<int>(known + *index);
  if (*index > std::numeric_limits<int>::max()) return Error{fmt::format("vertex {} does not exist", in_quotes(word))};
  return static_cast<int>(*index - 1);
}

/// What stands behind the coordinates of vertices: a weight, which only rational curves and surfaces have a use for, or
/// a colour, which is no part of the format but often written.
class BehindVertices {
 public:
  /// The words behind a vertex. The error names no line.
  std::optional<Error> append(std::string_view words, int vertex, int line) {
    int numbers = 0;
    bool one = false;
    for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
      const auto number = parse_number(word);
      if (!number) {
        return Error{fmt::format("{} behind the coordinates of vertex {} is not a number", in_quotes(word), vertex)};
      }
      one = *number == 1;
      ++numbers;
    }
    if (numbers == 1 && !one) weights_.add(line);
    if (numbers == 3 || numbers == 4) colours_.add(line);
    if (numbers == 2 || numbers > 4) others_.add(line);
    return std::nullopt;
  }

  void add_notes(std::vector<std::string>& notes) const {
    const auto add = [&](const Ignored& ignored, std::string_view what, std::string_view why) {
      if (ignored.count == 0) return;
      notes.push_back(fmt::format("ignored the {} of {} {} ({}){}", what, ignored.count,
                                  ignored.count == 1 ? "vertex" : "vertices", ignored.where(), why));
    };
    add(weights_, "weights", ": polygons have no use for them");
    add(colours_, "colours", "");
    add(others_, "numbers behind the coordinates", ", which are neither a weight nor a colour");
  }

 private:
  Ignored weights_, colours_, others_;
};

}  // namespace

Result<PolygonFile> parse_obj(std::string_view text, const ReadLimits& limits) {
  PolygonFile file;
  VertexList vertices(limits.vertices);
  GroupList groups(limits);
  TagCounts tags;
  BehindVertices behind;
  Statements statements(text);
  while (const auto statement = statements.next()) {
    std::string_view words = statement->text;
    const std::string_view keyword = take_word(words);
    if (keyword == "v") {
      const auto position = vertices.append(words);
      if (!position) return at_line(statement->number, position.error().message);
      if (const auto error = behind.append(words, vertices.size(), statement->number)) {
        return at_line(statement->number, error->message);
      }
      file.source.vertex_lines.push_back(statement->number);
    } else if (keyword == "f") {
      if (static_cast<int>(file.cage.faces.size()) == limits.faces) {
        return at_line(statement->number, fmt::format("more than {} faces: the file is too large", limits.faces));
      }
      std::vector<int> face;
      for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
        const auto corner = parse_corner(word, vertices.size());
        if (!corner) return at_line(statement->number, corner.error().message);
        if (static_cast<int>(face.size()) == limits.face_size) {
          return at_line(statement->number, fmt::format("a face of more than {} vertices", limits.face_size));
        }
        face.push_back(*corner);
      }
      if (const auto error = groups.append(static_cast<int>(file.cage.faces.size()))) {
        return at_line(statement->number, error->message);
      }
      file.cage.faces.push_back(std::move(face));
      file.source.face_lines.push_back(statement->number);
    } else if (keyword == "g" || keyword == "o") {
      const auto error = keyword == "g" ? groups.begin_groups(words) : groups.begin_object(words);
      if (error) return at_line(statement->number, error->message);
    } else if (keyword == "t") {
      tags.append(words, statement->number);
    }
  }
  if (vertices.size() == 0 && file.cage.faces.empty()) {
    return Error{
        "neither OBJ nor OFF nor PLY: there is no line of an OBJ vertex or face, and no keyword of OFF or PLY at the "
        "start"};
  }
  if (file.cage.faces.empty()) {
    return Error{
        "the file has vertices but no faces (no line that begins with f); curves, points and free-form surfaces are "
        "not read"};
  }
  file.cage.vertices = vertices.points();
  file.cage.groups = groups.take();
  file.notes = tags.notes();
  behind.add_notes(file.notes);
  return file;
}

}  // namespace umbilic
