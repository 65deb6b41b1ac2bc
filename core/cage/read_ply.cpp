// SPDX-License-Identifier: MIT
/// \file
/// Reads of PLY the properties x, y and z of the elements vertex and the list vertex_indices, or vertex_index, of the
/// elements face; see ply_header.h.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cage/formats.h"
#include "cage/ply_header.h"
#include "cage/ply_values.h"
#include "cage/text.h"

namespace umbilic {

namespace {

constexpr std::string_view kVertex = "vertex";
constexpr std::string_view kFace = "face";
constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 2> kCorners{"vertex_indices", "vertex_index"};

/// The properties that are read, as indices of the properties of their elements.
struct PlyRoles {
  std::array<std::size_t, 3> axes{};
  std::size_t corners = 0;
};

/// The only property of this name. The error names the line of the element.
Result<std::size_t> only_property(const PlyElement& element, std::string_view name) {
  const auto begin = element.properties.begin(), end = element.properties.end();
  const auto named = [&](const PlyProperty& property) { return property.name == name; };
  const auto first = std::find_if(begin, end, named);
  if (first == end) return at_line(element.line, fmt::format("the element {} has no property {}", element.name, name));
  if (std::find_if(first + 1, end, named) != end) {
    return at_line(element.line, fmt::format("the element {} has two properties {}", element.name, name));
  }
  return static_cast<std::size_t>(first - begin);
}

std::optional<Error> find_axes(const PlyElement& vertices, PlyRoles& roles) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto property = only_property(vertices, kAxes[axis]);
    if (!property) return property.error();
    if (vertices.properties[*property].length_type) {
      return at_line(vertices.line, fmt::format("the property {} is a list, not a number", kAxes[axis]));
    }
    roles.axes[axis] = *property;
  }
  return std::nullopt;
}

std::optional<Error> find_corners(const PlyElement& faces, PlyRoles& roles) {
  const auto there = std::find_if(kCorners.begin(), kCorners.end(), [&](std::string_view name) {
    return std::any_of(faces.properties.begin(), faces.properties.end(), [&](const auto& p) { return p.name == name; });
  });
  if (there == kCorners.end()) {
    return at_line(faces.line, fmt::format("the element face has no property {} or {}", kCorners[0], kCorners[1]));
  }
  const auto property = only_property(faces, *there);
  if (!property) return property.error();
  if (!faces.properties[*property].length_type) {
    return at_line(faces.line, fmt::format("the property {} is no list", faces.properties[*property].name));
  }
  roles.corners = *property;
  return std::nullopt;
}

/// Checks that the header announces vertices and faces, and no more of them than are read.
Result<PlyRoles> parse_roles(const PlyHeader& header, const ReadLimits& limits) {
  for (const PlyElement& element : header.elements) {
    if ((element.name == kVertex || element.name == kFace) && header.find(element.name) != &element) {
      return at_line(element.line, fmt::format("a second element {}", element.name));
    }
  }
  const PlyElement* vertices = header.find(kVertex);
  const PlyElement* faces = header.find(kFace);
  if (!vertices) return at_line(header.lines, "the header ends without an element vertex");
  if (!faces) {
    return at_line(header.lines, "the header ends without an element face: strips, edges and points are not read");
  }
  if (vertices->count > limits.vertices || faces->count > limits.faces) {
    const bool too_many = vertices->count > limits.vertices;
    const PlyElement& element = too_many ? *vertices : *faces;
    return at_line(element.line, fmt::format("{} elements {}: at most {} are read", element.count, element.name,
                                             too_many ? limits.vertices : limits.faces));
  }
  PlyRoles roles;
  if (auto error = find_axes(*vertices, roles)) return *error;
  if (auto error = find_corners(*faces, roles)) return *error;
  return roles;
}

template <class Values>
class PlyParser {
 public:
  PlyParser(const PlyHeader& header, const PlyRoles& roles, const ReadLimits& limits)
      : header_(header), roles_(roles), limits_(limits), values_(header), vertices_(limits.vertices) {}

  Result<PolygonFile> parse() {
    for (const PlyElement& element : header_.elements) {
      if (auto error = parse_all(element)) return *error;
    }
    if (values_.begin()) return behind();
    file_.cage.vertices = vertices_.points();
    file_.source.first_index = 0;
    return std::move(file_);
  }

 private:
  std::optional<Error> parse_all(const PlyElement& element) {
    if (element.properties.empty()) return std::nullopt;  // nothing of it is written
    const bool vertices = element.name == kVertex;
    for (long long number = 0; number < element.count; ++number) {
      if (!values_.begin()) {
        return values_.here(fmt::format("the file ends after {} of the {} elements {} that line {} announces", number,
                                        element.count, in_quotes(element.name), element.line));
      }
      auto error = vertices ? parse_vertex(element) : element.name == kFace ? parse_face(element) : skip(element);
      if (!error) error = values_.end();
      // Vertices are numbered from 0, as the faces name them.
      if (error) return values_.at(in_quotes(element.name), number + (vertices ? 0 : 1), error->message);
    }
    return std::nullopt;
  }

  std::optional<Error> parse_vertex(const PlyElement& element) {
    Vector3 position;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const auto axis = std::find(roles_.axes.begin(), roles_.axes.end(), p) - roles_.axes.begin();
      if (axis == 3) {
        if (auto error = skip(property)) return error;
        continue;
      }
      const Result<double> number = values_.number(property.type, property.name);
      if (!number) return number.error();
      if (!std::isfinite(*number)) return Error{fmt::format("the coordinate {} is not finite", property.name)};
      position[axis] = *number;
    }
    vertices_.add(position);
    values_.note_line(file_.source.vertex_lines);
    return std::nullopt;
  }

  std::optional<Error> parse_face(const PlyElement& element) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (auto error = p == roles_.corners ? parse_corners(element.properties[p]) : skip(element.properties[p])) {
        return error;
      }
    }
    values_.note_line(file_.source.face_lines);
    return std::nullopt;
  }

  std::optional<Error> parse_corners(const PlyProperty& property) {
    const Result<double> length = length_of(property);
    if (!length) return length.error();
    if (*length > limits_.face_size) return Error{fmt::format("a face of more than {} vertices", limits_.face_size)};
    const long long count = header_.find(kVertex)->count;
    std::vector<int> face;
    for (int corner = 0; corner < *length; ++corner) {
      const Result<double> index = values_.number(property.type, property.name);
      if (!index) return index.error();
      if (!(*index >= 0 && *index < static_cast<double>(count)) || std::floor(*index) != *index) {
        return Error{fmt::format("index {} does not exist: {}", *index,
                                 count > 0 ? fmt::format("{} vertices have the indices 0 to {}", count, count - 1)
                                           : "there are no vertices")};
      }
      face.push_back(static_cast<int>(*index));
    }
    file_.cage.faces.push_back(std::move(face));
    return std::nullopt;
  }

  std::optional<Error> skip(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      if (auto error = skip(property)) return error;
    }
    return std::nullopt;
  }

  std::optional<Error> skip(const PlyProperty& property) {
    const Result<double> length = property.length_type ? length_of(property) : 1.0;
    if (!length) return length.error();
    for (double read = 0; read < *length; ++read) {
      if (const Result<double> number = values_.number(property.type, property.name); !number) return number.error();
    }
    return std::nullopt;
  }

  /// How many numbers of a list follow: any whole number, which the file may not hold.
  Result<double> length_of(const PlyProperty& list) {
    const Result<double> length = values_.number(*list.length_type, list.name);
    if (!length) return length.error();
    if (!(*length >= 0 && std::isfinite(*length)) || std::floor(*length) != *length) {
      return Error{fmt::format("{} is no length of the list {}", *length, in_quotes(list.name))};
    }
    return *length;
  }

  Error behind() const { return values_.here("the file goes on behind the last element that its header announces"); }

  const PlyHeader& header_;
  PlyRoles roles_;
  ReadLimits limits_;
  Values values_;
  VertexList vertices_;
  PolygonFile file_;
};

}  // namespace

Result<PolygonFile> parse_ply(std::string_view file, const ReadLimits& limits) {
  const auto header = parse_ply_header(file);
  if (!header) return header.error();
  const auto roles = parse_roles(*header, limits);
  if (!roles) return roles.error();
  if (header->format == PlyFormat::kAscii) return PlyParser<PlyWords>(*header, *roles, limits).parse();
  return PlyParser<PlyBytes>(*header, *roles, limits).parse();
}

}  // namespace umbilic
