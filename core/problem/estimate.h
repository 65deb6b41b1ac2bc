// SPDX-License-Identifier: MIT
/// \file
/// How long a run will take and how much memory, as plain values. They are expectations: half or twice as long is
/// usual.
#pragma once

#include <vector>

namespace umbilic {

/// One level of a run that has not begun.
struct LevelEstimate {
  int level = 0;
  double patches = 0;
  double unknowns = 0;
  double evaluations = 0;
  double seconds = 0;
  double bytes = 0;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("level", self.level, "Catmull-Clark steps from the cage to the mesh whose points are moved");
    visit("patches", self.patches, "Faces of the mesh that the surface is evaluated on");
    visit("unknowns", self.unknowns, "About so many coordinates that the optimizer moves");
    visit("evaluations", self.evaluations, "Evaluations of energy and gradient that such levels usually take");
    visit("seconds", self.seconds, "Time that these take on this machine, with all that goes with them");
    visit("bytes", self.bytes, "Memory that the level takes, as far as runs are measured");
  }
};

struct Estimate {
  std::vector<LevelEstimate> levels;
  double seconds = 0;
  double bytes = 0;

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("levels", self.levels, "Those that the run will probably take, in order");
    visit("seconds", self.seconds, "Of all levels");
    visit("bytes", self.bytes, "Of the largest level");
  }
};

}  // namespace umbilic
