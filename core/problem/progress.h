// SPDX-License-Identifier: MIT
/// \file
/// The current state of a run.
#pragma once

#include <string_view>

namespace umbilic {

/// What a run is about to do; every `step` finishes at most one of these.
enum class Phase { kPrepare, kMinimize, kReport, kCompareCaps, kDone };

/// "prepare", "minimize", "report", "compare_caps", "done".
constexpr std::string_view name_of(Phase phase) {
  switch (phase) {
    case Phase::kPrepare: return "prepare";
    case Phase::kMinimize: return "minimize";
    case Phase::kReport: return "report";
    case Phase::kCompareCaps: return "compare_caps";
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
  /// Energy of the best surface of this level, by the minimizing rule; NaN before the first evaluation. If the surface
  /// exploits the error of that rule, the level continues with a finer one, by which the energy is higher.
  double energy = 0;
  double gradient_norm = 0;  ///< Euclidean norm of the best surface's gradient by the control points
  double predicted_decrease =
      0;  ///< estimate of how much this level can still decrease the energy; NaN before the first iteration
  double share_done = 0;    ///< of the run's time, as far as that can be told: from 0 to 1, and never falls
  double seconds_left = 0;  ///< until the run ends, as expected (driver/estimate.h)

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
    visit("share_done", self.share_done, "Of the time that the run will probably take, from 0 to 1; never falls");
    visit("seconds_left", self.seconds_left, "Until the run will probably end");
  }
};

}  // namespace umbilic
