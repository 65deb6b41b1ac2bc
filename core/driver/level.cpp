// SPDX-License-Identifier: MIT
/// \file
/// Builds the metric before the first iteration, and anew as the surface moves away from where it was built.
#include "driver/level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace umbilic {
namespace {

/// Iterations after which a metric costs less than the iterations that a fresh one saves.
constexpr int kMetricLifetime = 25;

/// Convergence is relative to at least this energy, so that functionals whose infimum is 0 end: a millionth of a
/// sphere's bending.
constexpr double kEnergyFloor = 1e-6 * 8 * std::numbers::pi;

/// Largest first displacement of a control point, relative to the cage's extent.
constexpr double kLargestStep = 0.1;

double extent(const Points& points) { return (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff(); }

}  // namespace

Level::Level(RefinedCage start, const LevelOptions& options)
    : number_(start.level),
      options_(options),
      start_(std::move(start.control)),
      surface_(std::move(start.mesh), options.cap, options.weights),
      objective_(surface_.energy()),
      next_metric_(std::make_unique<SobolevMetric>(surface_.layout(), options.weights, start_)) {}

void Level::start() {
  LbfgsOptions options;
  options.max_iterations = options_.max_iterations;
  options.tolerance = options_.tolerance;
  options.floor = kEnergyFloor;
  options.max_displacement = kLargestStep * extent(start_);
  lbfgs_ = std::make_unique<Lbfgs>(objective_, *metric_, SurfaceObjective::unknowns(start_), options);
}

bool Level::metric_is_stale() const {
  return lbfgs_->between_iterations() && lbfgs_->iterations() - metric_iteration_ >= kMetricLifetime;
}

bool Level::step() {
  if (cancelled_ || (lbfgs_ && lbfgs_->ended())) return true;
  if (!next_metric_ && metric_is_stale()) {
    next_metric_ = std::make_unique<SobolevMetric>(surface_.layout(), options_.weights, best());
  }
  if (!next_metric_) return lbfgs_->step();
  if (!next_metric_->advance()) return false;
  metric_ = std::move(next_metric_);
  if (!lbfgs_) {
    start();
  } else {
    lbfgs_->set_metric(*metric_);
    metric_iteration_ = lbfgs_->iterations();
  }
  return false;
}

void Level::cancel() {
  cancelled_ = true;
  if (lbfgs_) lbfgs_->cancel();
}

LevelReport Level::report(const EnergyReport& energies) const {
  LevelReport report;
  report.level = number_;
  report.patches = surface_.mesh().face_count();
  report.unknowns = static_cast<int>(start_.size());
  report.energy_reported = surface_.objective(energies);
  report.energy =
      lbfgs_ && lbfgs_->evaluations() > 0 ? lbfgs_->best_value() : surface_.energy().evaluate(start_, nullptr).energy;
  report.stop = StopReason::kCancelled;
  if (lbfgs_) {
    report.iterations = lbfgs_->iterations();
    report.evaluations = lbfgs_->evaluations();
    if (lbfgs_->ended()) report.stop = lbfgs_->stop();
  }
  return report;
}

}  // namespace umbilic
