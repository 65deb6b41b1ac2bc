// SPDX-License-Identifier: MIT
/// \file
/// The user's options for a run.
#pragma once

#include <optional>
#include <type_traits>

#include "energy/functional.h"
#include "problem/metric_choice.h"
#include "surface/cap_kind.h"

namespace umbilic {

struct RunOptions {
  Weights weights{};  ///< in the text form these are the problem's terms, outside its options
  CapKind cap = CapKind::kSmooth;
  int cap_rings = kUsualCapRings;  ///< a power of 2 up to kMostCapRings
  int first_level = 0;             ///< >= 0, Catmull-Clark steps from the cage to the first mesh whose points are moved
  int last_level = 2;              ///< >= first_level; limits: see Run::create
  int max_iterations = 1000;       ///< >= 0, per level
  double tolerance = 1e-6;         ///< >= 0: see StopReason::kConverged
  bool symmetry = true;            ///< whether the surface keeps the cage's symmetry
  MetricChoice metric = MetricChoice::kAutomatic;
  bool second_opinion = false;  ///< whether the report has the energies as another way of computing finds them, too
  std::optional<double> accuracy{};  ///< in (0, 1): chooses the last level and the tolerance, see Run::create

  CapChoice caps() const { return {cap, cap_rings}; }

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("cap", self.cap, "Surface near extraordinary vertices");
    visit("cap_rings", self.cap_rings,
          "The most rings of faces that a smooth cap takes: 1, 2, 4, 8 or 16; more than 4 only where faces come from "
          "refining");
    visit.pair("levels", self.first_level, self.last_level,
               "Catmull-Clark steps from the cage to the first and to the last mesh whose points are moved");
    visit("max_iterations", self.max_iterations, "Of each level");
    visit("tolerance", self.tolerance,
          "A level ends when the decrease still predicted is below tolerance * max(energy, 1e-6 * 8 pi)");
    visit("symmetry", self.symmetry, "Whether the surface keeps the symmetry of the cage");
    visit("metric", self.metric, "What the optimizer measures steps with");
    if (!std::is_const_v<Self> || self.second_opinion) {
      visit("second_opinion", self.second_opinion,
            "Whether the report also has the energies as another way of computing finds them, which takes seconds");
    }
    visit("accuracy", self.accuracy,
          "Ends with the first level from which the limit is known within this part of it: the last of levels does not "
          "count, and the tolerance is the greater of the given one and a fiftieth of this");
  }
};

/// Whether all options are in range; otherwise `error` names the one that is not.
bool in_range(const RunOptions& options, Error& error);

}  // namespace umbilic
