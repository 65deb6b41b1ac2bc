// SPDX-License-Identifier: MIT
/// \file
/// Between unknowns and control points.
#include "driver/surface_objective.h"

#include <algorithm>
#include <limits>

#include "driver/gauss_bonnet.h"

namespace umbilic {
namespace {

/// A patch whose area element falls below this fraction of the mean is about to collapse.
constexpr double kSmallestRegularity = 1e-9;

}  // namespace

SurfaceObjective::SurfaceObjective(const SurfaceEnergy& energy, const Unknowns& unknowns, int euler_characteristic,
                                   const Points& start)
    : energy_(energy), unknowns_(unknowns), euler_characteristic_(euler_characteristic) {
  const EnergyValue value = energy.evaluate(start, nullptr);
  start_energy_ = value.energy;
  largest_defect_ = std::max(kLargestDefect, 2 * gauss_bonnet_defect(value.gaussian, euler_characteristic));
}

void SurfaceObjective::evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const {
  unknowns_.control(unknowns, control_);
  const EnergyValue value = energy_.evaluate(control_, &gradient_);
  const bool whole = gauss_bonnet_defect(value.gaussian, euler_characteristic_) <= largest_defect_;
  result.value = whole ? value.energy : std::numeric_limits<double>::infinity();
  unknowns_.pull_back(gradient_, result.gradient);
  result.degenerate = !(value.regularity > kSmallestRegularity);
}

}  // namespace umbilic
