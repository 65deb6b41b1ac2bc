// SPDX-License-Identifier: MIT
/// \file
/// What holds a surface at its boundary.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "problem/members.h"

namespace umbilic {

/// Each holds what the one before it holds, too. What is held is that of the cage's own surface.
enum class BoundaryCondition {
  kFree,       ///< nothing
  kPosition,   ///< the boundary curve, with its parameters
  kTangent,    ///< the derivative across it as well
  kCurvature,  ///< and the second one
};

/// "free", "position", "tangent", "curvature".
constexpr std::string_view name_of(BoundaryCondition condition) {
  switch (condition) {
    case BoundaryCondition::kFree: return "free";
    case BoundaryCondition::kPosition: return "position";
    case BoundaryCondition::kTangent: return "tangent";
    case BoundaryCondition::kCurvature: return "curvature";
  }
  return "";
}

/// The condition of one loop of the boundary, or of a stretch of it.
struct LoopCondition {
  int loop = 0;
  std::optional<int> from{}, to{};
  BoundaryCondition condition = BoundaryCondition::kTangent;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit.required("loop", self.loop, "Number of the boundary, from 1, as reports of the cage list them");
    visit("from", self.from,
          "The vertex at which the stretch begins, with the surface on its left; the whole loop unless given");
    visit("to", self.to, "The vertex at which it ends");
    visit.required("condition", self.condition, "What is held there");
  }
};

struct BoundaryConditions {
  BoundaryCondition condition = BoundaryCondition::kTangent;
  std::vector<LoopCondition> loops{};

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("condition", self.condition, "Of every loop that is not listed");
    visit("loops", self.loops, "Of single loops, or stretches of them; later ones replace earlier ones");
  }
};

}  // namespace umbilic
