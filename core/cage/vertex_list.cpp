// SPDX-License-Identifier: MIT
/// \file
/// Reads a vertex, in the same way for every format.
#include <fmt/format.h>

#include <cmath>

#include "cage/formats.h"
#include "cage/text.h"

namespace umbilic {

Result<Vector3> VertexList::append(std::string_view& words) {
  if (size() == most_) return Error{fmt::format("more than {} vertices: the file is too large", most_)};
  Vector3 position;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = take_word(words);
    if (word.empty()) {
      return Error{fmt::format("vertex {} has {} coordinate{} instead of 3", size() + 1, axis, axis == 1 ? "" : "s")};
    }
    const auto number = parse_number(word);
    if (!number) return Error{fmt::format("coordinate {} of vertex {} is not a number", in_quotes(word), size() + 1)};
    if (!std::isfinite(*number)) {
      return Error{fmt::format("coordinate {} of vertex {} is not finite", in_quotes(word), size() + 1)};
    }
    position[axis] = *number;
  }
  add(position);
  return position;
}

void VertexList::add(const Vector3& position) {
  coordinates_.insert(coordinates_.end(), position.begin(), position.end());
}

Points VertexList::points() const { return Eigen::Map<const Points>(coordinates_.data(), size(), 3); }

}  // namespace umbilic
