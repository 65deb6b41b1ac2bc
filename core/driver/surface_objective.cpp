// SPDX-License-Identifier: MIT
/// \file
/// Between unknowns and control points.
#include "driver/surface_objective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace umbilic {
namespace {

/// A patch whose area element falls below this fraction of the mean is about to collapse.
constexpr double kSmallestRegularity = 1e-9;

/// Of the integral of the Gaussian curvature; the smallest neck's is 4 pi.
constexpr double kLargestDefect = 0.5;

}  // namespace

SurfaceObjective::SurfaceObjective(const SurfaceEnergy& energy, const Unknowns& unknowns, int euler_characteristic,
                                   const Points& start)
    : energy_(energy), unknowns_(unknowns), total_curvature_(2 * std::numbers::pi * euler_characteristic) {
  const EnergyValue value = energy.evaluate(start, nullptr);
  start_energy_ = value.energy;
  largest_defect_ = std::max(kLargestDefect, 2 * std::abs(value.gaussian - total_curvature_));
}

void SurfaceObjective::evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const {
  unknowns_.control(unknowns, control_);
  const EnergyValue value = energy_.evaluate(control_, &gradient_);
  const bool whole = std::abs(value.gaussian - total_curvature_) <= largest_defect_;
  result.value = whole ? value.energy : std::numeric_limits<double>::infinity();
  unknowns_.pull_back(gradient_, result.gradient);
  result.degenerate = !(value.regularity > kSmallestRegularity);
}

}  // namespace umbilic
