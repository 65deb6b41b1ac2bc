// SPDX-License-Identifier: MIT
/// \file
/// One level of a run: a surface minimized by L-BFGS in a metric that follows it, one unit of work at a time.
#pragma once

#include <memory>

#include "driver/surface.h"
#include "driver/surface_objective.h"
#include "optimize/lbfgs.h"
#include "optimize/sobolev.h"

namespace umbilic {

struct LevelOptions {
  CapKind cap;
  Weights weights;
  int max_iterations;
  double tolerance;
};

class Level {
 public:
  Level(RefinedCage start, const LevelOptions& options);

  /// One energy evaluation, or a part of a metric of no greater cost. Returns whether the level has ended.
  bool step();
  void cancel();

  bool preparing() const { return !lbfgs_; }
  int number() const { return number_; }
  const Surface& surface() const { return surface_; }
  /// Control points of the best surface so far.
  Points best() const { return lbfgs_ ? SurfaceObjective::control(lbfgs_->best()) : start_; }
  /// Null while preparing.
  const Lbfgs* lbfgs() const { return lbfgs_.get(); }

  /// What there is to say so far, with the best surface's energies by the reporting rule.
  LevelReport report(const EnergyReport& energies) const;

 private:
  void start();
  bool metric_is_stale() const;

  int number_;
  LevelOptions options_;
  Points start_;
  Surface surface_;
  SurfaceObjective objective_;
  std::unique_ptr<SobolevMetric> metric_, next_metric_;
  std::unique_ptr<Lbfgs> lbfgs_;
  int metric_iteration_ = 0;
  bool cancelled_ = false;
};

}  // namespace umbilic
