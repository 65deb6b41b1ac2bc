// SPDX-License-Identifier: MIT
/// \file
/// One level of a run: a surface minimized by L-BFGS in a metric that follows it, one unit of work at a time; and
/// when it is to go on with a finer quadrature rule.
#pragma once

#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "driver/surface.h"
#include "driver/surface_objective.h"
#include "optimize/surface_metric.h"
#include "problem/metric_choice.h"
#include "solve/lbfgs.h"

namespace umbilic {

/// Convergence is relative to at least this energy, so that functionals whose infimum is 0 end: a millionth of a
/// sphere's bending.
inline constexpr double kEnergyFloor = 1e-6 * 8 * std::numbers::pi;

/// Most unknowns of a level that the automatic choice gives the Hessian's metric.
inline constexpr int kMostHessianUnknowns = 8000;

struct LevelOptions {
  CapKind cap;
  Weights weights;
  int max_iterations;
  double tolerance;
  MetricChoice metric;
  /// Of the level before, whose surface this one can take on but for its caps: a minimum is not above it.
  double energy_before = std::numeric_limits<double>::infinity();
  int quadrature = 0;  ///< steps by which the rules are finer than usual, see driver/rules.h
};

class Level {
 public:
  /// Moves the points of `start`, and evaluates the surface on the mesh of `evaluated_level` >= start.level. What only
  /// the optimizer needs is made by the first steps, so that a surface that is but looked at is there soon.
  Level(RefinedCage start, int evaluated_level, const LevelOptions& options);

  /// One energy evaluation, or a part of a metric of no greater cost. Returns whether the level has ended.
  bool step();
  void cancel();

  /// Whether the best surface's energies should be looked at, as they are now and then and at the level's end.
  bool rule_is_in_question() const;
  /// Whether they tell that the surface makes use of the quadrature's error, and a finer rule and iterations are left.
  bool needs_finer_rule(const EnergyReport& energies) const;
  /// The level's continuation from its best surface, by rules one step finer.
  std::unique_ptr<Level> with_finer_rule() const;

  bool preparing() const { return !lbfgs_; }
  int number() const { return start_.level; }
  /// Whether the mesh whose points are moved is the one that the surface is evaluated on.
  bool evaluable() const { return surface_.level() == start_.level; }
  int quadrature() const { return options_.quadrature; }
  /// Whether it has seemed to converge above the level before, or in a metric that predicts nothing, so that its
  /// convergence says little.
  bool doubtful() const { return strict_ || vain_metrics_ > 0; }
  const Surface& surface() const { return surface_; }
  /// Control points on the evaluated mesh of the best surface so far.
  Points best() const { return lbfgs_ ? unknowns_.control(lbfgs_->best()) : surface_.start(); }
  /// The mesh whose points are moved, with the best ones so far.
  RefinedCage best_cage() const;
  /// Null while preparing.
  const Lbfgs* lbfgs() const { return lbfgs_.get(); }
  /// By all rules.
  int iterations() const { return before_.iterations + (lbfgs_ ? lbfgs_->iterations() : 0); }
  int evaluations() const { return before_.evaluations + (lbfgs_ ? lbfgs_->evaluations() : 0); }
  /// Of the best surface, by the rule that has evaluated it, and its gradient's norm; NaN before the first evaluation.
  double energy() const { return evaluated() ? lbfgs_->best_value() : before_.energy; }
  double gradient_norm() const { return evaluated() ? lbfgs_->best_gradient_norm() : before_.gradient_norm; }

  /// What there is to say so far, with the best surface's energies by the reporting rule.
  LevelReport report(const EnergyReport& energies) const;

 private:
  void prepare();
  void start();
  void make_metric();
  void rebuild_metric();
  bool metric_is_stale() const;
  bool metric_is_in_vain() const;
  bool goes_on();
  bool last_hessian_serves() const;
  bool above_the_level_before() const;
  bool evaluated() const { return lbfgs_ && lbfgs_->evaluations() > 0; }

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
  int vain_metrics_ = 0;                // the latest in a row that predict nothing
  std::optional<double> start_energy_;  // of the level's first surface by its first rule
  bool strict_ = false;                 // whether the tolerance has been tightened
  bool cancelled_ = false;

  /// What was done with coarser rules.
  struct {
    int iterations = 0, evaluations = 0, metrics = 0;
    double energy = std::numeric_limits<double>::quiet_NaN(), gradient_norm = energy;
  } before_;
};

}  // namespace umbilic
