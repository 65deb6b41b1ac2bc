// SPDX-License-Identifier: MIT
/// \file
/// Between unknowns and control points.
#include "driver/surface_objective.h"

namespace umbilic {
namespace {

/// A patch whose area element falls below this fraction of the mean is about to collapse.
constexpr double kSmallestRegularity = 1e-9;

}  // namespace

void SurfaceObjective::evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const {
  unknowns_.control(unknowns, control_);
  const EnergyValue value = energy_.evaluate(control_, &gradient_);
  result.value = value.energy;
  unknowns_.pull_back(gradient_, result.gradient);
  result.degenerate = !(value.regularity > kSmallestRegularity);
}

}  // namespace umbilic
