// SPDX-License-Identifier: MIT
/// \file
/// Builds the metric before the first iteration, and anew as the surface moves away from where it was built.
#include "driver/level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "driver/rules.h"
#include "optimize/hessian_metric.h"
#include "optimize/sobolev.h"

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

std::unique_ptr<SurfaceMetric> make_metric(const Surface& surface, const LevelOptions& options) {
  switch (options.metric) {
    case MetricChoice::kIdentity: return nullptr;
    case MetricChoice::kSobolev: return std::make_unique<SobolevMetric>(surface.energy(), surface.coordinates());
    case MetricChoice::kAutomatic:
    case MetricChoice::kHessian:
      return std::make_unique<HessianMetric>(surface.energy(), surface.coordinates(), hessian_rule(options.cap));
  }
  return nullptr;
}

class IdentityMetric : public Metric {
 public:
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override { return gradient; }
};
const IdentityMetric kIdentityMetric;

}  // namespace

Level::Level(RefinedCage start, const LevelOptions& options)
    : options_(options),
      surface_(std::move(start), options.cap, options.weights),
      objective_(surface_.energy(), surface_.coordinates()),
      metric_(make_metric(surface_, options)) {
  if (metric_) metric_->begin(surface_.start());
  building_ = metric_ != nullptr;
}

void Level::start() {
  LbfgsOptions options;
  options.max_iterations = options_.max_iterations;
  options.tolerance = options_.tolerance;
  options.floor = kEnergyFloor;
  options.max_displacement = kLargestStep * extent(surface_.start());
  const Metric& metric = metric_ ? static_cast<const Metric&>(*metric_) : kIdentityMetric;
  lbfgs_ = std::make_unique<Lbfgs>(objective_, metric, surface_.coordinates().unknowns(surface_.start()), options);
}

bool Level::metric_is_stale() const {
  return metric_ && lbfgs_->between_iterations() && lbfgs_->iterations() - metric_iteration_ >= kMetricLifetime;
}

bool Level::step() {
  if (cancelled_ || (lbfgs_ && lbfgs_->ended())) return true;
  if (lbfgs_ && !building_ && metric_is_stale()) {
    metric_->begin(best());
    building_ = true;
  }
  if (building_) {
    if (!metric_->advance()) return false;
    building_ = false;
    if (lbfgs_) metric_iteration_ = lbfgs_->iterations();
  }
  if (!lbfgs_) {
    start();
    return false;
  }
  return lbfgs_->step();
}

void Level::cancel() {
  cancelled_ = true;
  if (lbfgs_) lbfgs_->cancel();
}

LevelReport Level::report(const EnergyReport& energies) const {
  LevelReport report;
  report.level = number();
  report.patches = surface_.mesh().face_count();
  report.unknowns = surface_.coordinates().count();
  report.energy_reported = surface_.objective(energies);
  report.energy = lbfgs_ && lbfgs_->evaluations() > 0 ? lbfgs_->best_value()
                                                      : surface_.energy().evaluate(surface_.start(), nullptr).energy;
  report.stop = StopReason::kCancelled;
  if (lbfgs_) {
    report.iterations = lbfgs_->iterations();
    report.evaluations = lbfgs_->evaluations();
    if (lbfgs_->ended()) report.stop = lbfgs_->stop();
  }
  return report;
}

}  // namespace umbilic
