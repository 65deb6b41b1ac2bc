// SPDX-License-Identifier: MIT
/// \file
/// The limit of the levels' energies, with an error that covers what three levels can tell.
///
/// With the decreases d1 = E1 - E2 and d2 = E2 - E3 of the last three levels the observed order is p = log2(d1 / d2).
/// The limit is extrapolated with the smaller of p and the order q of bicubic elements, 2 for functionals of third
/// order and 4 for those of second: E3 - d2 / (2^q - 1). As the true order may be anything from 1 on, the limit lies in
/// [E3 - d2, E3], and the error is the distance to the farther end, plus what the optimizer and the quadrature leave.
#pragma once

#include <vector>

#include "driver/report.h"

namespace umbilic {

/// One level, as far as the limit is concerned.
struct LevelEnergy {
  double energy = 0;       ///< by the reporting rule
  double uncertainty = 0;  ///< of the minimization and the quadrature
  double bending = 0;      ///< of the same surface
  bool minimized = true;
  bool whole = true;  ///< as EnergyReport has it
};

/// Least observed order at which three levels are believed to be in their asymptotic range.
inline constexpr double kLeastOrder = 1.5;
/// Surfaces settle, not only energies, where their bending energy changes from the second to the third level by at most
/// this fraction of its change before, or of itself.
inline constexpr double kSettlingFraction = 0.5;
inline constexpr double kSettledFraction = 0.01;

/// `levels` are evaluable ones, in order; `third_order` whether the functional has a part of third order.
LimitReport extrapolate(const std::vector<LevelEnergy>& levels, bool third_order);

}  // namespace umbilic
