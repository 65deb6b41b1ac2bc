// SPDX-License-Identifier: MIT
/// \file
/// Weighs the term by the energy, so that it means the same for all functionals and surfaces.
#include "driver/parametrization.h"

#include <cassert>
#include <cmath>

namespace umbilic {

void ParametrizationStages::begin(const SurfaceEnergy& energy, const Points& control) {
  stage_ = 0;
  weigh(energy, control);
}

void ParametrizationStages::advance(const SurfaceEnergy& energy, const Points& control) {
  assert(!last());
  ++stage_;
  weigh(energy, control);
}

void ParametrizationStages::weigh(const SurfaceEnergy& energy, const Points& control) {
  weight_ = 0;
  ++begun_;
  if (last()) return;
  const EnergyValue value = energy.evaluate(control, nullptr, 1);
  const double weight = kParametrizationShares[stage_] * value.energy / value.parametrization;
  if (std::isfinite(weight)) weight_ = weight;
}

}  // namespace umbilic
