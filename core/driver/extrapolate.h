// SPDX-License-Identifier: MIT
/// \file
/// The limit of the levels' energies, with an error that covers what the last levels can tell.
///
/// d1 = E1 - E2 and d2 = E2 - E3 are the decreases of the last three levels, p = log2(d1 / d2) the observed order, and
/// q the order of bicubic elements: 2 for functionals of third order, 4 for those of second. The limit is extrapolated
/// with the smaller order, E3 - d2 / (2^min(p,q) - 1). As the true order may be anything from 1 on, it lies in
/// [E3 - d2, E3].
///
/// An error C h^q that decreases by d1 leaves c = d1 / 2^q / (2^q - 1) after E3. Where d2 < 2c, that is where p exceeds
/// q by more than log2((2^q - 1) / 2), the last decrease is too small for the elements, and says nothing of what is
/// left: either d1 has a part that vanishes faster, or in d2 parts of different signs cancel, as caps shrink from level
/// to level and may raise an energy. Then the limit is E3 - c, and lies in [E3 - 2c, E3]. Where the order before, p' =
/// log2(d0 / d1), is known, and p has fallen by more than is left of it, 2p < p', even d1 was as small, and c is d0 /
/// 4^q / (2^q - 1).
///
/// The error is the distance to the farther end, plus what the optimizer and the quadrature leave.
///
/// No surface is below the functional's lower bound (energy/lower_bounds.h), and so no limit: one that is extrapolated
/// below moves up to the bound, and its error is then the distance to the upper end, which stays. What a bar has below
/// the bound is cut off: `lower` is where it ends.
///
/// Without a limit the least energy of a whole level stands in for it, as an upper bound.
#pragma once

#include <vector>

#include "problem/report.h"

namespace umbilic {

/// One level, as far as the limit is concerned.
struct LevelEnergy {
  double energy = 0;       ///< by the reporting rule
  double uncertainty = 0;  ///< of the minimization and the quadrature
  double bending = 0;      ///< of the same surface
  bool minimized = true;
  bool whole = true;  ///< whether the energy can be the surface's: EnergyReport::credible
};

/// Least observed order at which three levels are believed to be in their asymptotic range.
inline constexpr double kLeastOrder = 1.5;
/// Surfaces settle, not only energies, where their bending energy changes from the second to the third level by at most
/// this fraction of its change before, or of itself.
inline constexpr double kSettlingFraction = 0.5;
inline constexpr double kSettledFraction = 0.01;

/// `levels` are evaluable ones, in order; `third_order` whether the functional has a part of third order.
LimitReport extrapolate(const std::vector<LevelEnergy>& levels, bool third_order, double lower_bound = 0);

}  // namespace umbilic
