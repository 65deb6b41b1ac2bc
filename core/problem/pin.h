// SPDX-License-Identifier: MIT
/// \file
/// What is asked of one point of the surface: to stay, or to lie somewhere, with a normal or without.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "base/result.h"
#include "problem/members.h"

namespace umbilic {

/// x, y, z in the cage's own coordinates.
using Coordinates3 = std::array<double, 3>;

/// Elements are numbered from 1, as in OBJ files, in the order of the cage after it was validated.
///
///     {"vertex": 17}                                                    // stays where it is
///     {"face": 3, "uv": [0.5, 0.25], "at": [0, null, 1.5]}               // y stays free
///     {"vertex": 4, "position": false, "normal": [0, 0, 1]}             // only the normal
///
/// In a quad, (u, v) is (0, 0) at the first corner, (1, 0) at the second and (0, 1) at the last. A face of another size
/// has such coordinates only after one Catmull-Clark step, in the quad around each of its corners: (0, 0) at the
/// corner, (1, 0) at the middle of the edge to the next, (1, 1) in the middle of the face. `corner` names it.
struct Pin {
  std::optional<int> vertex{}, face{}, corner{};
  std::optional<std::array<double, 2>> uv{};
  std::optional<Coordinates3> at{};  ///< NaN where the coordinate is free
  bool position = true;
  /// Whether the surface's own normal is kept; or the normal, of any length.
  std::optional<std::variant<bool, Coordinates3>> normal{};

  bool holds_normal() const { return normal && *normal != std::variant<bool, Coordinates3>(false); }

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("vertex", self.vertex, "The limit point of this vertex, counted from 1; or else:");
    visit("face", self.face, "A point of this face, counted from 1");
    visit("corner", self.corner, "Of a face that is no quad: in the quad around this corner, counted from 1");
    visit("uv", self.uv, "Where in the face: [0, 0] at its first corner, [1, 0] at the next, [0, 1] at the last");
    visit("at", self.at, "Where the point lies; null leaves a coordinate free. Where it is, unless given");
    visit("position", self.position, "Whether the point is held");
    visit("normal", self.normal, "The surface's normal there, pointing outward; true keeps the one that it has");
  }
};

/// Whether the pin says what it holds, in numbers that can be; `error` begins with the member that does not. Whether
/// the cage has the vertex or the face, only its user can know.
bool in_range(const Pin& pin, Error& error);

}  // namespace umbilic
