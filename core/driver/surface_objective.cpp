// SPDX-License-Identifier: MIT
/// \file
/// Converts between unknowns and control points.
#include "driver/surface_objective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "driver/contradiction.h"
#include "driver/gauss_bonnet.h"

namespace umbilic {
namespace {

/// A patch is about to collapse if its area element is below this fraction of the mean.
constexpr double kSmallestRegularity = 1e-9;

/// By how much a defect that is too large may exceed that of the point before. Without it a double cover of a sphere,
/// whose defect stays at 4 pi, could not move at all.
constexpr double kDefectSlack = 2;

}  // namespace

SurfaceObjective::SurfaceObjective(const SurfaceEnergy& energy, const Unknowns& unknowns, double gaussian,
                                   const Points& start, double lower_bound,
                                   std::function<double(const Points&)> turning, const ClosenessTerm* closeness)
    : energy_(energy), unknowns_(unknowns), gaussian_(gaussian), turning_(std::move(turning)), closeness_(closeness) {
  const EnergyValue value = energy.evaluate(start, nullptr);
  const double start_defect = defect(value, start);
  least_energy_ = std::min((1 - kMostAllowed) * lower_bound, value.energy);
  start_energy_ = value.energy + (closeness ? closeness->evaluate(start, nullptr) : 0);
  start_is_whole_ = start_defect <= kLargestDefect;
  largest_defect_ = std::max(kLargestDefect, kDefectSlack * start_defect);
}

double SurfaceObjective::defect(const EnergyValue& value, const Points& control) const {
  return std::abs(value.gaussian + (turning_ ? turning_(control) : 0) - gaussian_);
}

void SurfaceObjective::evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const {
  unknowns_.control(unknowns, control_);
  const EnergyValue value = energy_.evaluate(control_, &gradient_, parametrization_);
  last_defect_ = defect(value, control_);
  const bool credible = last_defect_ <= largest_defect_ && value.energy >= least_energy_;
  last_parametrization_ = value.parametrization;
  result.value = credible ? value.energy + value.parametrization : std::numeric_limits<double>::infinity();
  if (closeness_) result.value += closeness_->evaluate(control_, &gradient_);
  unknowns_.pull_back(gradient_, result.gradient);
  result.degenerate = !(value.regularity > kSmallestRegularity);
}

void SurfaceObjective::accept() const {
  largest_defect_ = std::max(kLargestDefect, std::min(largest_defect_, kDefectSlack * last_defect_));
}

}  // namespace umbilic
