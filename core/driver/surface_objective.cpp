// SPDX-License-Identifier: MIT
/// \file
/// Reshapes unknowns into control points and back.
#include "driver/surface_objective.h"

namespace umbilic {
namespace {

/// A patch whose area element falls below this fraction of the mean is about to collapse.
constexpr double kSmallestRegularity = 1e-9;

}  // namespace

void SurfaceObjective::evaluate(const Eigen::VectorXd& at, Evaluation& result) const {
  Points gradient;
  const EnergyValue value = energy_.evaluate(control(at), &gradient);
  result.value = value.energy;
  result.gradient = unknowns(gradient);
  result.degenerate = !(value.regularity > kSmallestRegularity);
}

Eigen::VectorXd SurfaceObjective::unknowns(const Points& control) {
  return Eigen::Map<const Eigen::VectorXd>(control.data(), control.size());
}

Points SurfaceObjective::control(const Eigen::VectorXd& unknowns) {
  return Eigen::Map<const Points>(unknowns.data(), unknowns.size() / 3, 3);
}

}  // namespace umbilic
