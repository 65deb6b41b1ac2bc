// SPDX-License-Identifier: MIT
/// \file
/// Builds the metric before the first iteration, and again when the surface has moved away from where it was built.
#include "driver/level.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "driver/equations.h"
#include "driver/gauss_bonnet.h"
#include "driver/metric_for_level.h"
#include "driver/rules.h"
#include "driver/thickness.h"
#include "optimize/hessian_metric.h"
#include "optimize/sobolev.h"

namespace umbilic {
namespace {

/// After this many iterations a new metric costs less than the iterations that it saves.
constexpr int kHessianLifetime = 10;
constexpr int kSobolevLifetime = 25;
/// The same for a metric that another level built for other targets.
constexpr int kTakenLifetime = 5;

/// Far from a minimum a Hessian may need so much of the Sobolev product that it contributes nothing itself. After this
/// many uninformative metrics in a row the Sobolev metric is used alone, unless the surface has so few patches that the
/// cost does not matter.
constexpr int kUninformativeInARow = 3;
constexpr int kCheapPatches = 2100;

/// Tolerance of levels that only prepare the first evaluable one.
constexpr double kPreparingTolerance = 1e-3;

/// Iterations between two checks of the quadrature's error, each of which costs one or two evaluations.
constexpr int kIterationsBetweenChecks = 100;

/// Factor of the tolerance after a level has converged above the level before.
constexpr double kToleranceReduction = 1e-3;

/// Largest displacement of a control point in the first trial, relative to the cage's extent.
constexpr double kLargestStep = 0.1;

double extent(const Points& points) { return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff(); }

class IdentityMetric : public Metric {
 public:
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override { return gradient; }
};
const IdentityMetric kIdentityMetric;

/// What is minimized, at the surface's start.
double objective_value(const Surface& surface) {
  const double energy = surface.energy().evaluate(surface.start(), nullptr).energy;
  return energy + (surface.closeness() ? surface.closeness()->evaluate(surface.start(), nullptr) : 0);
}

/// Whether a reason says that there is little left to gain, which what cannot be the surface's energy says nothing of.
bool claims_a_minimum(StopReason reason) {
  return reason == StopReason::kConverged || reason == StopReason::kRoundOff ||
         reason == StopReason::kLineSearchStalled;
}

Unknowns make_unknowns(const RefinedCage& cage, const Coordinates& coordinates, const Surface& surface,
                       const std::shared_ptr<const AffineSubspace>& solutions) {
  if (solutions) return Unknowns(coordinates, solutions);
  if (surface.level() == cage.level) return Unknowns(coordinates);
  Refinement step = catmull_clark(cage.mesh);
  Eigen::SparseMatrix<double> stencil = step.stencil;
  for (int level = cage.level + 1; level < surface.level(); ++level) {
    step = catmull_clark(step.mesh);
    stencil = (Eigen::SparseMatrix<double>(step.stencil) * stencil).eval();
  }
  return Unknowns(Coordinates(surface.mesh(), surface.symmetry()), coordinates, stencil);
}

}  // namespace

Level::Level(RefinedCage start, int evaluated_level, const LevelOptions& options)
    : options_(options),
      start_(std::move(start)),
      coordinates_(start_.mesh, start_.symmetry, held_points(start_, options.cap)),
      surface_(refine(start_with_held_points(), evaluated_level - start_.level), options.cap, options.weights,
               options.quadrature, options.fixed_area),
      gauge_(gauge_of(options.weights)),
      solutions_(solutions_of(start_, coordinates_)),
      unknowns_(make_unknowns(start_, coordinates_, surface_, solutions_)),
      metric_choice_(metric_for_level(options.metric, third_order(options.weights), surface_.symmetry().order,
                                      unknowns_.count())) {
  if (start_.is_constrained() && !leaves_size_open(start_)) gauge_.scaling = false;
}

/// Puts held points of the start exactly where they are held.
const RefinedCage& Level::start_with_held_points() {
  if (!start_.held.empty()) start_.control = coordinates_.control(coordinates_.unknowns(start_.control));
  return start_;
}

/// The optimizer's variables at control points of `start_`, or those of the nearest points that it can move to.
Eigen::VectorXd Level::unknowns_of(const Points& control) const {
  const Eigen::VectorXd all = coordinates_.unknowns(control);
  return solutions_ ? solutions_->coordinates(all) : all;
}

RefinedCage Level::best_cage() const {
  RefinedCage cage = start_;
  if (lbfgs_) {
    cage.control = solutions_ ? unknowns_.control(lbfgs_->best()) : coordinates_.control(lbfgs_->best());
  }
  return cage;
}

LbfgsOptions Level::optimizer_options() const {
  LbfgsOptions options;
  options.max_iterations = options_.max_iterations;
  options.tolerance = evaluable() ? options_.tolerance : std::max(options_.tolerance, kPreparingTolerance);
  options.floor = kEnergyFloor;
  options.max_displacement = kLargestStep * extent(start_.control);
  if (!stages_.last()) {
    options.tolerance = std::max(options.tolerance, kStageTolerance);
    options.model_alone = 1;
  }
  return options;
}

const Metric& Level::first_metric() const {
  if (mapped_metric_) return *mapped_metric_;
  return metric_ ? static_cast<const Metric&>(*metric_) : kIdentityMetric;
}

void Level::start() {
  lbfgs_ = std::make_unique<Lbfgs>(*objective_, first_metric(), unknowns_of(start_.control), optimizer_options());
}

void Level::prepare() {
  std::function<double(const Points&)> turning;
  if (holds_tangents(start_.boundary, start_.mesh)) {
    turning = [constant = surface_.turning(surface_.start())](const Points&) { return constant; };
  } else if (surface_.mesh().is_open()) {
    turning = [this](const Points& control) { return surface_.turning(control); };
  }
  objective_ =
      std::make_unique<SurfaceObjective>(surface_.energy(), unknowns_, surface_.expected_gaussian(), surface_.start(),
                                         surface_.lower_bound(), std::move(turning), surface_.closeness());
  if (!start_energy_) start_energy_ = objective_->start_energy();
  if (!start_is_in_question()) prepare_metric();
}

bool Level::start_is_in_question() const {
  return !start_.is_constrained() && !start_.mesh.is_open() && !objective_->start_is_whole() &&
         options_.max_iterations > 0 && !thicker_ && thicknesses_tried_ < kThicknessRatios.size();
}

void Level::try_thicker_start() {
  const double ratio = kThicknessRatios[thicknesses_tried_++];
  const Points thicker = thickened(start_.control, find_components(start_.mesh), ratio);
  const Eigen::VectorXd unknowns = coordinates_.unknowns(thicker);
  const EnergyValue value = surface_.energy().evaluate(unknowns_.control(unknowns), nullptr);
  const double defect = gauss_bonnet_defect(value.gaussian, surface_.mesh().euler_characteristic());
  if (defect <= kThickDefect && std::isfinite(value.energy)) thicker_ = coordinates_.control(unknowns);
}

void Level::prepare_metric() {
  if (metric_choice_ == MetricChoice::kIdentity || metric_) return;
  if (metric_choice_ == MetricChoice::kNewton && options_.even_parameters) {
    stages_.begin(surface_.energy(), surface_.start());
    objective_->set_parametrization(stages_.weight());
  }
  make_metric();
  rebuild_metric();
}

void Level::make_metric() {
  factorizations_ = factorizations();
  if (metric_choice_ == MetricChoice::kSobolev) {
    own_metric_ = std::make_unique<SobolevMetric>(surface_.energy(), unknowns_, gauge_, surface_.closeness());
  } else {
    own_metric_ = std::make_unique<HessianMetric>(surface_.layout(), unknowns_, options_.weights,
                                                  hessian_rule(options_.cap, options_.weights, options_.quadrature),
                                                  gauge_, options_.fixed_area, surface_.closeness(),
                                                  metric_choice_ == MetricChoice::kNewton);
  }
  metric_ = own_metric_.get();
  if (lbfgs_) lbfgs_->set_metric(*metric_);
  mapped_metric_.reset();
  metric_owner_.reset();
}

bool Level::metric_is_stale() const {
  if (!metric_ || !lbfgs_->between_iterations() || (last_hessian_suffices() && lbfgs_->has_nearly_converged()))
    return false;
  const int lifetime = metric_owner_ ? kTakenLifetime : metric_->knows_hessian() ? kHessianLifetime : kSobolevLifetime;
  return lbfgs_->iterations() - metric_iteration_ >= lifetime;
}

bool Level::hessian_is_uninformative() const {
  return uninformative_metrics_ >= kUninformativeInARow && surface_.layout().patch_count() > kCheapPatches;
}

bool Level::step() {
  if (cancelled_ || (lbfgs_ && lbfgs_->ended())) return true;
  if (!objective_) {
    prepare();
    return false;
  }
  if (!lbfgs_ && start_is_in_question()) {
    try_thicker_start();
    if (!start_is_in_question()) prepare_metric();
    return false;
  }
  if (lbfgs_ && !building_ && metric_is_stale()) {
    if (options_.metric == MetricChoice::kAutomatic && hessian_is_uninformative()) {
      metric_choice_ = MetricChoice::kSobolev;
      make_metric();
    }
    rebuild_metric();
  }
  if (building_) {
    if (!metric_->advance()) return false;
    building_ = false;
    ++metrics_;
    uninformative_metrics_ = metric_->predicts() ? 0 : uninformative_metrics_ + 1;
    if (lbfgs_) {
      metric_iteration_ = lbfgs_->iterations();
      if (metric_->knows_hessian()) lbfgs_->forget();
    }
  }
  if (!lbfgs_) {
    start();
    return false;
  }
  const int iterations = lbfgs_->iterations();
  const double best = lbfgs_->best_value();
  const bool ended = lbfgs_->step();
  if (lbfgs_->best_value() != best) best_parametrization_ = objective_->last_parametrization();
  if (lbfgs_->iterations() > iterations) objective_->accept();
  return ended && !should_continue();
}

/// Goes on with a better metric where one that is another level's, or not positive definite, has found no way down.
bool Level::with_better_metric() {
  const bool stuck = lbfgs_->stop() == StopReason::kRoundOff || lbfgs_->stop() == StopReason::kLineSearchStalled;
  if (!stuck || !metric_) return false;
  if (metric_owner_) {
    rebuild_metric();
  } else if (metric_->positive()) {
    return false;
  } else {
    metric_->make_positive();
    building_ = true;
  }
  lbfgs_->resume(optimizer_options().tolerance);
  return true;
}

/// Begins the next stage of the parametrization's term where this one has ended.
bool Level::next_stage() {
  if (stages_.last() || !claims_a_minimum(lbfgs_->stop())) return false;
  stages_.advance(surface_.energy(), best());
  objective_->set_parametrization(stages_.weight());
  const LbfgsOptions options = optimizer_options();
  lbfgs_->restart(options.tolerance, options.model_alone);
  best_parametrization_ = objective_->last_parametrization();
  rebuild_metric();
  return true;
}

/// Whether convergence should not be trusted yet: the metric can still become better, or the level has ended above the
/// one before, as in a slow valley.
bool Level::should_continue() {
  if (with_better_metric() || next_stage()) return true;
  if (lbfgs_->stop() != StopReason::kConverged) return false;
  const bool in_question = metric_ && (metric_owner_ || !metric_->settled() ||
                                       (!metric_->predicts() && uninformative_metrics_ < kUninformativeInARow));
  if (!in_question) {
    if (strict_ || !above_the_level_before()) return false;
    strict_ = true;
  }
  lbfgs_->resume(strict_ ? kToleranceReduction * options_.tolerance : options_.tolerance);
  if (metric_ && !metric_owner_ && !metric_->settled() &&
      (last_hessian_suffices() || metric_choice_ == MetricChoice::kNewton)) {
    metric_->settle();
    building_ = true;
  } else if (metric_) {
    rebuild_metric();
  }
  return true;
}

/// Whether a Hessian from some iterations ago is still good enough to decide that a level has converged. It is for
/// functionals of second order. For those of third order the result may depend on every digit of the path, and there is
/// little to gain.
bool Level::last_hessian_suffices() const { return !third_order(options_.weights); }

bool Level::above_the_level_before() const {
  return evaluable() && lbfgs_->best_value() >
                            options_.energy_before + kHarmlessError * std::max(options_.energy_before, kEnergyFloor);
}

void Level::rebuild_metric() {
  if (metric_owner_) make_metric();
  if (lbfgs_) metric_->gained(lbfgs_->latest_gain());
  metric_->begin(best(), stages_.weight());
  building_ = true;
}

void Level::cancel() {
  cancelled_ = true;
  if (lbfgs_) lbfgs_->cancel();
}

bool Level::should_check_rule() const {
  if (!lbfgs_ || cancelled_ || !evaluable() || !stages_.last()) return false;
  const int iterations = lbfgs_->iterations();
  return lbfgs_->ended() ||
         (lbfgs_->between_iterations() && iterations > 0 && iterations % kIterationsBetweenChecks == 0);
}

bool Level::needs_finer_rule(const EnergyReport& energies) const {
  if (options_.quadrature >= kFinestRules || lbfgs_->iterations() >= options_.max_iterations) return false;
  if (unknowns_.count() == 0) return false;  // what cannot move exploits nothing
  // A wider cap may let a level begin far above the one before; returning from there is no gain.
  const double start = std::min(*start_energy_, options_.energy_before);
  return exploits_quadrature(options_.weights, start, lbfgs_->best_value(), surface_.objective(energies));
}

LevelReport Level::report(const EnergyReport& energies) const {
  LevelReport report;
  report.level = number();
  report.patches = surface_.mesh().surface_face_count();
  report.unknowns = unknowns_.count();
  report.energy_reported = surface_.objective(energies);
  report.energy = evaluated() ? energy() : objective_value(surface_);
  report.stop = StopReason::kCancelled;
  report.metric = metric_choice_;
  const Work work = work_done();
  report.metrics = work.metrics;
  report.factorizations = work.factorizations;
  report.parametrization_stages = work.stages;
  report.quadrature = options_.quadrature;
  report.iterations = work.iterations;
  report.evaluations = work.evaluations;
  report.evaluable = evaluable();
  report.cap_rings = surface_.narrowest_cap();
  report.thickened = thickened_;
  report.credible = energies.credible();
  if (lbfgs_ && lbfgs_->ended()) report.stop = lbfgs_->stop();
  if (lbfgs_) report.predicted_decrease = lbfgs_->predicted_decrease();
  if (claims_a_minimum(report.stop)) {
    if (energies.below_bound) {
      report.stop = StopReason::kBelowBound;
    } else if (!energies.resolved) {
      report.stop = StopReason::kNotResolved;
    }
  }
  return report;
}

}  // namespace umbilic
