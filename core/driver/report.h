// SPDX-License-Identifier: MIT
/// \file
/// What a run, an evaluation or a gradient check has to say, as plain values; no layer below core/cli knows JSON.
#pragma once

#include <array>
#include <string_view>

#include "cage/cage.h"
#include "energy/functional.h"
#include "optimize/stop_reason.h"

namespace umbilic {

struct EnergyReport {
  /// In the order of `Functional`; third-order values include the factor area. NaN where the quantity diverges.
  std::array<double, kFunctionalCount> functionals{};
  double area = 0;
  double gaussian = 0;  ///< integral of the Gaussian curvature
  /// |objective by the reporting rule - objective by the minimizing rule|, of the run's functional (of bending, where
  /// there is none).
  double quadrature_error = 0;
};

struct LevelReport {
  int level = 0;
  int patches = 0;             ///< faces of the control mesh
  int unknowns = 0;            ///< coordinates that the optimizer moves
  double energy = 0;           ///< by the minimizing rule
  double energy_reported = 0;  ///< by the reporting rule
  int iterations = 0;
  int evaluations = 0;
  double seconds = 0;
  StopReason stop = StopReason::kConverged;
};

struct EvaluationReport {
  int level = 0;
  int patches = 0;
  EnergyReport energies;
};

struct GradientReport {
  int level = 0;
  int unknowns = 0;
  int directions = 0;
  double analytic = 0;           ///< directional derivative of the direction with the largest mismatch
  double difference = 0;         ///< the same by central differences
  double relative_mismatch = 0;  ///< the largest
  double tolerance = 0;
  bool ok = false;
};

}  // namespace umbilic
