// SPDX-License-Identifier: MIT
/// \file
/// Which of a run's levels is its result.
#pragma once

#include <cmath>
#include <memory>
#include <tuple>

#include "driver/level.h"
#include "problem/report.h"

namespace umbilic {

/// A level that has ended, with what ranks it among the others.
struct EndedLevel {
  std::unique_ptr<Level> level;
  LevelReport report;
  EnergyReport energies;

  /// The less, the better a result it is. Energies that may be the surface's come before those that hide curvature, and
  /// these before those that are below a bound; then the least one counts.
  std::tuple<int, bool, double> rank() const {
    const double energy = report.energy_reported;
    if (!std::isfinite(energy) || !std::isfinite(energies.quadrature_error)) return {3, !report.evaluable, 0};
    if (energies.below_bound) return {2, !report.evaluable, 0};
    return {energies.resolved ? 0 : 1, !report.evaluable, energy};
  }
};

}  // namespace umbilic
