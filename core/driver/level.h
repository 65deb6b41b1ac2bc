// SPDX-License-Identifier: MIT
/// \file
/// One level of a run: a surface minimized by L-BFGS in a metric that follows it, one unit of work at a time.
#pragma once

#include <memory>
#include <numbers>

#include "driver/metric_choice.h"
#include "driver/surface.h"
#include "driver/surface_objective.h"
#include "optimize/lbfgs.h"
#include "optimize/surface_metric.h"

namespace umbilic {

/// Convergence is relative to at least this energy, so that functionals whose infimum is 0 end: a millionth of a
/// sphere's bending.
inline constexpr double kEnergyFloor = 1e-6 * 8 * std::numbers::pi;

struct LevelOptions {
  CapKind cap;
  Weights weights;
  int max_iterations;
  double tolerance;
  MetricChoice metric;
};

class Level {
 public:
  /// Moves the points of `start`, and evaluates the surface on the mesh of `evaluated_level` >= start.level. What only
  /// the optimizer needs is made by the first steps, so that a surface that is but looked at is there soon.
  Level(RefinedCage start, int evaluated_level, const LevelOptions& options);

  /// One energy evaluation, or a part of a metric of no greater cost. Returns whether the level has ended.
  bool step();
  void cancel();

  bool preparing() const { return !lbfgs_; }
  int number() const { return start_.level; }
  const Surface& surface() const { return surface_; }
  /// Control points on the evaluated mesh of the best surface so far.
  Points best() const { return lbfgs_ ? unknowns_.control(lbfgs_->best()) : surface_.start(); }
  /// The mesh whose points are moved, with the best ones so far.
  RefinedCage best_cage() const;
  /// Null while preparing.
  const Lbfgs* lbfgs() const { return lbfgs_.get(); }

  /// What there is to say so far, with the best surface's energies by the reporting rule.
  LevelReport report(const EnergyReport& energies) const;

 private:
  void prepare();
  void start();
  void make_metric();
  void rebuild_metric();
  bool metric_is_stale() const;
  bool metric_is_in_vain() const;

  LevelOptions options_;
  RefinedCage start_;
  Coordinates coordinates_;  // of `start_`
  Surface surface_;
  Unknowns unknowns_;
  std::unique_ptr<SurfaceObjective> objective_;  // null before the first step, as is the metric
  MetricChoice metric_choice_;                   // never kAutomatic
  std::unique_ptr<SurfaceMetric> metric_;        // null for the identity
  bool building_ = false;
  std::unique_ptr<Lbfgs> lbfgs_;
  int metric_iteration_ = 0, metrics_ = 0;
  bool cancelled_ = false;
};

}  // namespace umbilic
