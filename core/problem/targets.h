// SPDX-License-Identifier: MIT
/// \file
/// What can change under a run: the weights of its terms, where its pins and the points of its cage lie, and how
/// strongly it is pulled back.
///
///     {"terms": {"bending": 0.9, "mvs_cross": 0.1}, "pins": [{}, {"at": [0, 0, 1.5]}], "closeness": 40}
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "base/types.h"
#include "problem/constraints.h"
#include "problem/members.h"
#include "problem/options.h"
#include "problem/pin.h"

namespace umbilic {

/// Where a pin lies from now on. What is not given stays.
struct PinTarget {
  std::optional<Coordinates3> at{};      ///< NaN where the pin leaves the coordinate free, and only there
  std::optional<Coordinates3> normal{};  ///< of any length, of a pin that holds the normal

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("at", self.at, "Where the point lies; null where the pin leaves the coordinate free");
    visit("normal", self.normal, "The normal that it holds");
  }
};

/// What is not given stays.
struct Targets {
  static constexpr Unknown kUnknown = Unknown::kRefused;
  std::optional<Weights> terms{};
  std::vector<PinTarget> pins{};      ///< one for each of the problem's, in their order; or none
  std::optional<double> closeness{};  ///< the weight, where the problem has one
  /// Of all points of the problem's cage, before it is filled. What is held follows: held faces, boundaries, pins that
  /// hold the surface where the cage has it, and what the surface is pulled to.
  std::optional<Points> points{};

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("terms", self.terms, "Weights of the functionals whose sum is minimized, 0 unless given");
    visit("pins", self.pins, "One for each of the problem's pins");
    visit("closeness", self.closeness, "The weight of the term that pulls to the cage's own surface");
    visit("points", self.points, "x, y, z of each point of the cage, one after another");
  }
};

/// Writes the targets into what a problem asks for, but for the cage's points. If they do not fit it, nothing changes,
/// and the error names the member: "pins[1].at[0]: null, but the pin holds this coordinate".
std::optional<Error> set_targets(const Targets& targets, RunOptions& options, Constraints& constraints);

}  // namespace umbilic
