// SPDX-License-Identifier: MIT
/// \file
/// What a run knows, and its steps from level to level: minimize, report, compare caps, refine.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "driver/best_energies.h"
#include "driver/cage_faces.h"
#include "driver/closeness_search.h"
#include "driver/constraints_report.h"
#include "driver/ended_level.h"
#include "driver/estimate.h"
#include "driver/extrapolate.h"
#include "driver/level.h"
#include "driver/run.h"

namespace umbilic {

struct Run::State {
  State(const RunOptions& asked, Constraints given, RefinedCage prepared, const Cage& asked_cage);

  RunOptions options;
  Constraints constraints;
  RefinedCage cage;  // at level 0
  Cage own;          // that it was made from
  /// Whether orbits are of the cage's symmetry, not of one that a start was found to have, or of a part.
  bool has_cages_orbits = true;
  CageFaces cage_faces;
  HeldRegions held_regions;     // of the cage
  std::vector<int> held_faces;  // of the cage, sorted
  int required_level = 0;       // the first level that can be evaluated
  std::unique_ptr<Level> level;
  std::unique_ptr<Level> narrower;  // the level before `level`, with narrower caps, while these are compared
  std::optional<EndedLevel> best;   // of the levels before `level`, as far as there are any
  std::size_t result = 0;           // the index of the best level, once the run is done
  std::vector<LevelReport> levels;
  std::vector<LevelEnergy> energies_of_levels;  // of the evaluable ones
  Progress progress;
  double level_seconds = 0;
  Forecast forecast;
  bool cancelled = false;
  std::optional<double> within;  // the largest deviation that is allowed, in unit coordinates
  std::optional<ClosenessSearch> search;
  std::optional<double> fixed_area;  // see Surface
  BestEnergies energies;

  LevelOptions level_options() const;
  /// Of a run that goes on with the level that is there; `near`: from a surface that has been minimized.
  void begin_forecast(bool near);
  /// What the forecast says after some work.
  void update_forecast();
  void update_progress();
  /// One unit of work.
  void unit();
  /// Begins with a weight by which a deviation of half the bound everywhere costs a tenth of the start's energy.
  void begin_search(double bound);
  void replace_level(std::unique_ptr<Level> other);
  std::optional<Error> retarget(const Targets& targets);
  /// Of a run whose cage has moved.
  void follow_cage(Cage moved);
  LimitReport limit() const;
  void end_level();
  /// Whether the run ends with the level that has ended.
  bool is_last() const;
  /// Whether there is a limit whose error would know that of the caps, if those of the level before were narrower, too.
  bool caps_are_in_question() const;
  void compare_caps();
  /// From a level that has ended to the next, or to the result.
  void go_on();
};

}  // namespace umbilic
