// SPDX-License-Identifier: MIT
/// \file
/// What the surface must keep besides its topology. Elements of the cage are numbered from 1, as in OBJ files and in
/// messages.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/result.h"
#include "problem/boundary_condition.h"
#include "problem/members.h"
#include "problem/pin.h"

namespace umbilic {

/// Faces of the cage: those of some groups of its file, and some by their numbers.
struct FaceSelection {
  std::vector<std::string> groups;
  std::vector<int> faces;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("groups", self.groups, "Names of groups (g) and objects (o) of the file");
    visit("faces", self.faces, "Numbers of faces, from 1");
  }
};

/// How near the surface stays to the cage's own: what is minimized has the term weight * integral of |X - X0|^2 dA,
/// over what is free, between points of the same parameters. Exactly one of the two is given.
struct Closeness {
  std::optional<double> weight{};  ///< >= 0, in energy / length^4
  std::optional<double> within{};  ///< > 0: the least weight is found for which no point is farther than this

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("weight", self.weight, "Of the term that pulls the surface to the cage's own, in energy / length^4");
    visit("within", self.within,
          "Or: the distance that no point of the surface may be from the cage's own, in its units");
  }
};

/// Whether exactly one is given, in range; otherwise `error` says what is wrong.
bool in_range(const Closeness& closeness, Error& error);

/// At most one of `hold` and `free` is given. The surface over held faces stays that of the cage, and so do all control
/// points that it depends on; the surface over the others joins it as smoothly as the surface is inside (with
/// continuous curvature, except at extraordinary vertices).
struct Constraints {
  std::optional<FaceSelection> hold{};  ///< the faces that are held
  std::optional<FaceSelection> free{};  ///< the faces that are not; all others are held
  std::vector<Pin> pins{};              ///< points and normals that are held
  /// Whether pins, the selections of faces above and listed boundaries also hold, or free, what the cage's symmetry
  /// maps theirs to, so that the symmetry is kept. A cage that is symmetric within the digits of its file is made so
  /// exactly first.
  bool symmetric = false;

  std::optional<Closeness> closeness{};
  std::optional<BoundaryConditions> boundary{};  ///< of open surfaces; tangent everywhere unless given
  /// Faces of the cage that are holes: the surface has no points over them (Cage::holes).
  std::optional<FaceSelection> holes{};

  bool holds_faces() const { return hold || free; }
  bool any() const { return holds_faces() || !pins.empty() || closeness; }

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("hold", self.hold, "Faces whose surface stays as it is in the cage");
    visit("free", self.free, "The only faces whose surface may move; not together with hold");
    if (!std::is_const_v<Self> || !self.pins.empty()) visit("pins", self.pins, "Points and normals that are held");
    if (!std::is_const_v<Self> || self.symmetric) {
      visit("symmetric", self.symmetric,
            "Whether pins, hold or free, and listed boundaries are copied to all places to which the cage's symmetry "
            "maps "
            "theirs, so that the symmetry is kept; false unless given");
    }
    visit("closeness", self.closeness, "How near the surface stays to the cage's own");
    visit("boundary", self.boundary, "What is held at the boundaries of an open surface; the tangents unless given");
    visit("holes", self.holes, "Faces that are holes, over which there is no surface, but what fills them");
  }
};

/// Whether no two of the constraints exclude each other by their form; otherwise `error` says which.
bool in_range(const Constraints& constraints, Error& error);

}  // namespace umbilic
