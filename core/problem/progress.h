// SPDX-License-Identifier: MIT
/// \file
/// Where a run stands.
#pragma once

#include <string_view>

namespace umbilic {

/// What a run is about to do; every `step` finishes at most one of these.
enum class Phase { kPrepare, kMinimize, kReport, kDone };

/// "prepare", "minimize", "report", "done".
constexpr std::string_view name_of(Phase phase) {
  switch (phase) {
    case Phase::kPrepare: return "prepare";
    case Phase::kMinimize: return "minimize";
    case Phase::kReport: return "report";
    case Phase::kDone: return "done";
  }
  return "";
}

struct Progress {
  Phase phase = Phase::kPrepare;
  int level = 0;  ///< the current one, or the result's when the run is done
  int ended_levels = 0;
  int iterations = 0;         ///< in this level
  int evaluations = 0;        ///< in this level
  int total_evaluations = 0;  ///< over all levels
  /// Of the best surface of this level, by the minimizing rule; NaN before the first evaluation. Where the surface
  /// makes use of that rule's error the level goes on from it with a finer rule, by which its energy is higher.
  double energy = 0;
  double gradient_norm = 0;       ///< Euclidean, of the best surface, with respect to the control points
  double predicted_decrease = 0;  ///< estimate of what this level can still gain; NaN before the first iteration

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("phase", self.phase, "What the run does next");
    visit("level", self.level, "Catmull-Clark steps from the cage to the mesh whose points are moved");
    visit("ended_levels", self.ended_levels, "Number of levels that have ended");
    visit("iterations", self.iterations, "In this level");
    visit("evaluations", self.evaluations, "In this level");
    visit("total_evaluations", self.total_evaluations, "Over all levels");
    visit("energy", self.energy, "Of the best surface of this level; null before the first evaluation");
    visit("gradient_norm", self.gradient_norm, "Euclidean, of the best surface");
    visit("predicted_decrease", self.predicted_decrease, "What the level can still gain; null before the first step");
  }
};

}  // namespace umbilic
