// SPDX-License-Identifier: MIT
/// \file
/// How long a run will take: before it begins, and while it goes on.
///
/// A level takes its set-up, its evaluations and its metrics. What each of them costs is known (driver/level_work.h,
/// driver/machine_speed.h). How many there will be nobody knows: they are what such levels usually took on the cages of
/// `npm run bench -- estimates`, which also tells how often that was within a factor of two. While a run goes on, the
/// seconds that its work has taken say how fast the machine is, and the evaluations that it has taken how many are
/// left.
#pragma once

#include <vector>

#include "driver/level_work.h"
#include "problem/estimate.h"
#include "problem/options.h"

namespace umbilic {

/// How often a level probably computes what it consists of.
struct ExpectedCounts {
  double evaluations = 0, metrics = 0;
};

/// Of a level that is the `number`th one that can be evaluated, from 0; negative for those before them. `near`: it
/// begins with a surface that has been minimized already.
ExpectedCounts expected_counts(const LevelSize& size, int number, const RunOptions& options, bool near);

/// How many of a run's levels that can be evaluated it will probably take.
int expected_levels(const RunOptions& options, int at_most);

class Forecast {
 public:
  Forecast() = default;
  /// Of a run whose first level is this large. `required` is the first level that can be evaluated; `near` as above.
  Forecast(const LevelSize& first, int required, const RunOptions& options, bool near = false);

  Estimate estimate() const;

  /// What a run has done of its level so far.
  void level_advanced(int level, int evaluations, double seconds);
  /// A level has ended, after so many evaluations and seconds.
  void level_ended(int level, int evaluations, double seconds);

  /// An ended level is minimized once more, from where it ended: what has been done of that so far, and that it ended.
  void level_repeated(int level, int evaluations, double seconds);
  void repetition_ended();

  double seconds_left() const;
  /// Of the time of the whole run; never falls.
  double share_done() const { return share_; }

 private:
  /// A level as it was expected.
  struct Planned {
    LevelSize size;
    ExpectedCounts expected;
    LevelWork work;
    double bytes = 0;

    /// Of an evaluation, with its part of the metrics.
    double each() const { return work.energy + work.step + work.metric * expected.metrics / expected.evaluations; }
    double seconds() const { return work.set_up + expected.evaluations * each(); }
    double slowness() const;
  };
  const Planned* find(int level) const;
  double slowness_of(const Planned& level) const;
  void update();

  std::vector<Planned> levels_;
  int level_ = -1, evaluations_ = 0;                       // of the level that goes on
  int repeated_ = -1, repeated_evaluations_ = 0;           // of the level that is minimized once more
  double repeated_seconds_ = 0;                            // of that
  double seconds_ = 0;                                     // of that level
  double ended_seconds_ = 0, ended_work_ = 0, share_ = 0;  // of those that have ended
};

}  // namespace umbilic
