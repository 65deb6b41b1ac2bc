// SPDX-License-Identifier: MIT
/// \file
/// Reads OFF by its definition in Geomview, and files with one vertex and one face per line that deviate from it.
///
///     [ST][C][N]OFF                   # the keyword may be left out
///     vertices faces edges            # the number of edges is not used
///     x y z  nx ny nz  r g b a  s t   # of each vertex; what follows x y z as N, C and ST say
///     size index … index  colour      # of each face; the colour, up to four numbers, ends the line
///
/// There, lines may end anywhere else. But many programs write the keyword without the prefixes, three numbers of a
/// colour instead of four, or no number of edges. Such files can be read all the same if each vertex and each face has
/// a line. So a text is read by lines, and by the definition where that fails.
#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cage/formats.h"
#include "cage/off_header.h"
#include "cage/text.h"

namespace umbilic {

namespace {

/// Takes up to `most` numbers off the front of what `take` gives; returns how many there were.
template <class Take>
Result<int> skip_numbers(const Take& take, int most, std::string_view behind) {
  int numbers = 0;
  while (numbers < most) {
    const std::string_view word = take();
    if (word.empty()) break;
    if (!parse_number(word)) return Error{fmt::format("{} behind {} is not a number", in_quotes(word), behind)};
    ++numbers;
  }
  return numbers;
}

class OffParser {
 public:
  OffParser(std::string_view text, const ReadLimits& limits, bool by_lines)
      : limits_(limits), words_(text, by_lines), vertices_(limits.vertices) {}

  Result<PolygonFile> parse() {
    const auto header = parse_off_header(words_);
    if (!header) return header.error();
    header_ = *header;
    if (header_.vertices > limits_.vertices || header_.faces > limits_.faces) {
      return at_line(header_.line, fmt::format("{} vertices and {} faces: at most {} and {} are read", header_.vertices,
                                               header_.faces, limits_.vertices, limits_.faces));
    }
    file_.source.first_index = 0;
    for (long long vertex = 0; vertex < header_.vertices; ++vertex) {
      if (!words_.begin()) return truncated(vertex, header_.vertices, "vertices");
      file_.source.vertex_lines.push_back(words_.line());
      if (const auto error = parse_vertex()) return at_line(file_.source.vertex_lines.back(), error->message);
    }
    for (long long face = 0; face < header_.faces; ++face) {
      if (!words_.begin()) return truncated(face, header_.faces, "faces");
      file_.source.face_lines.push_back(words_.line());
      if (const auto error = parse_face()) return at_line(file_.source.face_lines.back(), error->message);
    }
    if (words_.begin()) {
      return at_line(words_.line(), fmt::format("more lines than the {} vertices and {} faces that line {} announces",
                                                header_.vertices, header_.faces, header_.line));
    }
    file_.cage.vertices = vertices_.points();
    add_notes();
    return std::move(file_);
  }

  /// Whether a vertex was read, and seems to have a line of its own: then errors are better told by lines.
  bool lines_fit() const {
    return first_vertex_words_ >= 3 && first_vertex_words_ < 3 * (3 + header_.keyword.numbers());
  }

 private:
  Error truncated(long long found, long long expected, std::string_view what) const {
    return at_line(words_.line(), fmt::format("the file ends after {} of the {} {} that line {} announces", found,
                                              expected, what, header_.line));
  }

  std::optional<Error> parse_vertex() {
    const int line = words_.line();
    coordinates_.clear();
    int words = 0;
    for (; words < 3; ++words) {
      const std::string_view word = words_.word();
      if (word.empty()) break;
      coordinates_.append(word).append(" ");
    }
    if (vertices_.size() == 0) first_vertex_words_ = words;
    std::string_view view = coordinates_;
    if (const auto position = vertices_.append(view); !position) return position.error();
    const int announced = header_.keyword.numbers();
    const auto numbers = skip_numbers([&] { return words_.word(); },
                                      words_.by_lines() ? std::numeric_limits<int>::max() : announced, "a vertex");
    if (!numbers) return numbers.error();
    if (vertices_.size() == 1) first_vertex_words_ += *numbers;
    if (!words_.by_lines() && *numbers < announced) {
      return Error{fmt::format("{} numbers behind vertex {}, where {} announces {}", *numbers, vertices_.size(),
                               header_.keyword_text, announced)};
    }
    if (*numbers > announced) more_numbers_.add(line);
    return std::nullopt;
  }

  std::optional<Error> parse_face() {
    const std::string_view first = words_.word();
    const auto size = parse_integer(first);
    if (!size || *size < 0) {
      return Error{fmt::format("expected a face's number of vertices, found {}", in_quotes(first))};
    }
    if (*size > limits_.face_size) return Error{fmt::format("a face of more than {} vertices", limits_.face_size)};
    std::vector<int> face;
    for (long long corner = 0; corner < *size; ++corner) {
      const std::string_view word = words_.word();
      if (word.empty()) return Error{fmt::format("a face of {} vertices has only {}", *size, corner)};
      const auto index = parse_integer(word);
      if (!index) return Error{fmt::format("{} is not a vertex index", in_quotes(word))};
      if (*index < 0 || *index >= header_.vertices) {
        return Error{fmt::format("index {} does not exist: {} vertices have the indices 0 to {}", *index,
                                 header_.vertices, header_.vertices - 1)};
      }
      face.push_back(static_cast<int>(*index));
    }
    constexpr int kMostOfColour = 4;
    const int line = words_.line();
    const auto numbers = skip_numbers([&] { return take_word(words_.rest()); }, kMostOfColour + 1, "a face");
    if (!numbers) return numbers.error();
    if (*numbers > kMostOfColour) {
      return Error{fmt::format("more than the {} numbers of a colour behind the vertices of a face", kMostOfColour)};
    }
    if (*numbers > 0) coloured_faces_.add(line);
    file_.cage.faces.push_back(std::move(face));
    return std::nullopt;
  }

  void add_notes() {
    std::string announced;
    const auto add = [&](bool there, std::string_view what) {
      if (there) announced.append(announced.empty() ? "" : ", ").append(what);
    };
    add(header_.keyword.normals, "normals");
    add(header_.keyword.colours, "colours");
    add(header_.keyword.texture, "texture coordinates");
    if (!announced.empty()) {
      file_.notes.push_back(fmt::format("ignored of the vertices what {} on line {} announces: {}",
                                        header_.keyword_text, header_.keyword_line, announced));
    }
    if (more_numbers_.count > 0) {
      file_.notes.push_back(fmt::format("ignored numbers behind the coordinates of {} {} ({})", more_numbers_.count,
                                        more_numbers_.count == 1 ? "vertex" : "vertices", more_numbers_.where()));
    }
    if (coloured_faces_.count > 0) {
      file_.notes.push_back(fmt::format("ignored the colours of {} face{} ({})", coloured_faces_.count,
                                        coloured_faces_.count == 1 ? "" : "s", coloured_faces_.where()));
    }
  }

  ReadLimits limits_;
  OffWords words_;
  OffHeader header_;
  VertexList vertices_;
  PolygonFile file_;
  std::string coordinates_;  // of one vertex, in one line
  int first_vertex_words_ = 0;
  Ignored more_numbers_, coloured_faces_;
};

}  // namespace

Result<PolygonFile> parse_off(std::string_view text, const ReadLimits& limits) {
  bool lines_fit = true;
  const auto read = [&](bool by_lines) {
    OffParser parser(text, limits, by_lines);
    auto file = parser.parse();
    if (by_lines) lines_fit = parser.lines_fit();
    return file;
  };
  auto by_lines = read(true);
  if (by_lines) return by_lines;
  auto by_words = read(false);
  return by_words || !lines_fit ? std::move(by_words) : std::move(by_lines);
}

}  // namespace umbilic
