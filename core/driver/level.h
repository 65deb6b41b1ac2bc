// SPDX-License-Identifier: MIT
/// \file
/// One level of a run: minimizes a surface by L-BFGS in a metric that follows it, one unit of work at a time. Also
/// decides when to continue with a finer quadrature rule.
#pragma once

#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "driver/parametrization.h"
#include "driver/surface.h"
#include "driver/surface_objective.h"
#include "optimize/gauge.h"
#include "optimize/surface_metric.h"
#include "problem/metric_choice.h"
#include "problem/report.h"
#include "solve/lbfgs.h"

namespace umbilic {

/// Convergence is relative to at least this energy, a millionth of a sphere's bending, so that functionals whose
/// infimum is 0 end.
inline constexpr double kEnergyFloor = 1e-6 * 8 * std::numbers::pi;

struct LevelOptions {
  CapChoice cap;
  Weights weights;
  int max_iterations;
  double tolerance;
  MetricChoice metric;
  /// Energy of the level before. Apart from the caps, this level can represent the same surface, so its minimum is not
  /// higher.
  double energy_before = std::numeric_limits<double>::infinity();
  int quadrature = 0;  ///< by how many steps the rules are refined, see driver/rules.h
  /// The constant factor of third-order functionals where faces are held, see Surface.
  std::optional<double> fixed_area{};
  /// Whether Newton's metric begins with a term that makes the parametrization even, see driver/parametrization.h. A
  /// surface that has already been minimized needs none.
  bool even_parameters = true;
};

class Level {
 public:
  /// Moves the points of `start`, and evaluates the surface on the mesh of `evaluated_level` >= start.level, which must
  /// be equal where something is held. The first steps make what only the optimizer needs, so that a surface that is
  /// only viewed is available soon.
  Level(RefinedCage start, int evaluated_level, const LevelOptions& options);

  /// One energy evaluation, or a part of a metric that costs no more. Returns whether the level has ended.
  bool step();
  void cancel();

  /// Whether the quadrature error of the best surface should be checked now; true at intervals and at the level's end.
  bool should_check_rule() const;
  /// Whether these energies show that the surface exploits the quadrature error, and a finer rule and iterations are
  /// left.
  bool needs_finer_rule(const EnergyReport& energies) const;
  /// A level that continues from the best surface, with rules one step finer.
  std::unique_ptr<Level> with_finer_rule() const;
  /// A level that continues from the best surface, pulled to the cage's own with another weight.
  std::unique_ptr<Level> with_closeness(double weight) const;
  /// A level that continues from the best surface of another one with other weights, or other targets of the same pins,
  /// or another place of what is held: from its points, moved to the targets. The rows must not contradict one another.
  /// Until it has built a metric of its own it takes that of the other level, which is near.
  static std::unique_ptr<Level> retargeted(std::unique_ptr<Level> before, RefinedCage targets,
                                           const LevelOptions& options);
  /// The level with smooth caps half as wide as its narrowest, from the best surface; see driver/extrapolate.h. The
  /// narrowest must have two rings at least.
  std::unique_ptr<Level> with_narrower_caps() const;
  /// The level with a thicker start, where the samples miss curvature of its own and see all of that one; see
  /// driver/thickness.h. Null otherwise.
  std::unique_ptr<Level> with_thicker_start() const;

  bool preparing() const { return !lbfgs_; }
  int number() const { return start_.level; }
  /// Whether the surface is evaluated on the mesh whose points are moved.
  bool evaluable() const { return surface_.level() == start_.level; }
  int quadrature() const { return options_.quadrature; }
  int unknowns() const { return unknowns_.count(); }
  /// Whether the level's convergence says little: it seemed to converge above the level before, or in an uninformative
  /// metric.
  bool doubtful() const { return strict_ || uninformative_metrics_ > 0; }
  const Surface& surface() const { return surface_; }
  /// Control points of the best surface so far, on the evaluated mesh.
  Points best() const { return lbfgs_ ? unknowns_.control(lbfgs_->best()) : surface_.start(); }
  /// The mesh whose points are moved, with the best points so far.
  RefinedCage best_cage() const;
  /// Null while the level is being prepared.
  const Lbfgs* lbfgs() const { return lbfgs_.get(); }
  /// Iterations with all rules.
  int iterations() const { return before_.iterations + (lbfgs_ ? lbfgs_->iterations() : 0); }
  int evaluations() const { return before_.evaluations + (lbfgs_ ? lbfgs_->evaluations() : 0); }
  /// Energy of the best surface, by the rule with which it was evaluated, and the norm of the gradient of what is
  /// minimized; NaN before the first evaluation.
  double energy() const { return evaluated() ? lbfgs_->best_value() - best_parametrization_ : before_.energy; }
  double gradient_norm() const { return evaluated() ? lbfgs_->best_gradient_norm() : before_.gradient_norm; }

  /// The report so far, with the best surface's energies by the reporting rule.
  LevelReport report(const EnergyReport& energies) const;

 private:
  /// Work that a level has done with those that it goes on from, and where it has led.
  struct Work {
    int iterations = 0, evaluations = 0, metrics = 0, factorizations = 0, stages = 0;
    double energy = std::numeric_limits<double>::quiet_NaN(), gradient_norm = energy;
  };

  Work work_done() const;
  int factorizations() const { return factorizations_ + (own_metric_ ? own_metric_->factorizations() : 0); }
  const RefinedCage& start_with_held_points();
  Eigen::VectorXd unknowns_of(const Points& control) const;
  void prepare();
  void prepare_metric();
  bool start_is_in_question() const;
  void try_thicker_start();
  LbfgsOptions optimizer_options() const;
  void start();
  void make_metric();
  void rebuild_metric();
  void take_metric(std::unique_ptr<Level> from);
  const Metric& first_metric() const;
  Eigen::SparseMatrix<double> directions() const;
  bool has_orthonormal_unknowns() const { return !solutions_ || solutions_->orthonormal(); }
  bool metric_is_stale() const;
  bool hessian_is_uninformative() const;
  bool with_better_metric();
  bool next_stage();
  bool should_continue();
  bool last_hessian_suffices() const;
  bool above_the_level_before() const;
  bool evaluated() const { return lbfgs_ && lbfgs_->evaluations() > 0; }

  LevelOptions options_;
  RefinedCage start_;
  Coordinates coordinates_;  // of `start_`
  Surface surface_;
  Gauge gauge_;
  std::shared_ptr<const AffineSubspace> solutions_;  // of the equations, over `coordinates_`; null without any
  Unknowns unknowns_;
  std::unique_ptr<SurfaceObjective> objective_;  // null before the first step, like the metric
  MetricChoice metric_choice_;                   // never kAutomatic
  std::unique_ptr<SurfaceMetric> own_metric_;    // null before it is made
  SurfaceMetric* metric_ = nullptr;              // the one in use; null for the identity
  std::unique_ptr<Level> metric_owner_;          // the level whose metric is in use; null if it is the own one
  std::unique_ptr<Metric> mapped_metric_;        // that level's metric in these unknowns, if its unknowns are others
  bool building_ = false;
  std::unique_ptr<Lbfgs> lbfgs_;
  std::size_t thicknesses_tried_ = 0;  // of kThicknessRatios
  std::optional<Points> thicker_;      // points of `start_` whose curvature the samples see
  bool thickened_ = false;             // whether `start_` are such points
  int metric_iteration_ = 0, metrics_ = 0;
  int factorizations_ = 0;              // of metrics before `own_metric_`
  int uninformative_metrics_ = 0;       // number of latest metrics that were uninformative
  std::optional<double> start_energy_;  // energy of the level's first surface, by its first rule
  ParametrizationStages stages_;
  double best_parametrization_ = 0;  // the parametrization's term of the best surface
  bool strict_ = false;              // whether the tolerance has been tightened
  bool cancelled_ = false;

  Work before_;  // with coarser rules, or another pull to the cage's own surface
};

}  // namespace umbilic
