// SPDX-License-Identifier: MIT
/// \file
/// The limit of the levels' energies, with an error bar that covers what the last levels leave open.
///
/// d1 = E1 - E2 and d2 = E2 - E3 are the decreases of the last three levels, p = log2(d1 / d2) is the observed order,
/// and q the order of bicubic elements: 2 for functionals of third order, 4 for those of second. The limit is
/// extrapolated with the smaller order: E3 - d2 / (2^min(p,q) - 1).
///
/// Were both decreases the elements' error alone, p would be q; what has other orders moves p away to either side. So
/// the true order is taken to be lower than q by one more than p differs from it, but never below 1: it is at least
/// m = max(q - |p - q| - 1, 1), and the limit lies in [E3 - d2 / (2^m - 1), E3]. Beside the elements' error functionals
/// of second order have one of order 2, as curvature at an extraordinary vertex is wrong on an area that falls by 4
/// with each level. A sum of both with the observed order p, 2 <= p <= 4, leaves d2 (19 - 2^p) / 45, which is less than
/// what order p - 1 leaves. For functionals of third order m is 1.
///
/// Exception: d2 may be too small to be believed. An error C h^q that decreased by d1 leaves c = d1 / 2^q / (2^q - 1)
/// after E3. If d2 < 2c, that is if p exceeds q by more than log2((2^q - 1) / 2), elements of order q cannot explain
/// the small decrease, so it says nothing about what is left. Either d1 has a part that vanishes faster, or in d2 parts
/// of different signs cancel, since caps shrink from level to level and may raise an energy. Then the limit is E3 - c
/// and lies in [E3 - 2c, E3]. If the previous order p' = log2(d0 / d1) is known and p is less than half of it, d1 was
/// already too small, and c is d0 / 4^q / (2^q - 1).
///
/// Where two decreases in a row had an order from 3/2 to q + 1, m is 3/2 at least.
///
/// Caps (surface/cap.h) leave an error in energies of third order that falls with their width only. Where the narrowest
/// cap of the last level is wider than that of the level before, d2 knows this error too, as it falls by the same
/// factor; else the level before the last is minimized again with caps half as wide, which costs a quarter. What caps
/// leave falls to a third or less with each doubling of their width, about (`npm run bench -- caps`), and never was
/// more than the difference d of the two energies: it moves the limit by -d / 2, and the error takes as much more.
/// Where that level has not been minimized so, `caps_included` is false. Caps stay as wide where something held, a
/// boundary or another extraordinary vertex is near, and where they are as wide as they may become.
///
/// The error bar reaches to the farther end of the interval, and adds the errors of the optimizer and the quadrature.
///
/// No surface is below the functional's lower bound (energy/lower_bounds.h), and so no limit: one that is extrapolated
/// below moves up to the bound, and its error is then the distance to the upper end, which stays. What a bar has below
/// the bound is cut off: `lower` is where it ends.
///
/// Without a limit the least energy of a whole level stands in for it, as an upper bound.
#pragma once

#include <limits>
#include <vector>

#include "problem/report.h"

namespace umbilic {

/// What the extrapolation needs to know of a level.
struct LevelEnergy {
  double energy = 0;       ///< by the reporting rule
  double uncertainty = 0;  ///< error of the minimization and the quadrature
  double bending = 0;      ///< bending energy of the same surface
  bool minimized = true;
  bool resolved = true;  ///< whether the energy can be the surface's: EnergyReport::credible
  int cap_rings = 0;     ///< of the narrowest cap; 0 without caps
  /// The least energy of the same level with caps half as wide; NaN where it is not known.
  double with_narrower_caps = std::numeric_limits<double>::quiet_NaN();
};

/// Smallest observed order at which three levels are believed to be in their asymptotic range.
inline constexpr double kLeastOrder = 1.5;
/// The surfaces, not only their energies, are taken to converge if the bending energy changes from the second level to
/// the third by at most this fraction of its previous change, or of itself.
inline constexpr double kSettlingFraction = 0.5;
inline constexpr double kSettledFraction = 0.01;

/// `levels` are the evaluable levels, in order; `third_order` says whether the functional has a part of third order.
LimitReport extrapolate(const std::vector<LevelEnergy>& levels, bool third_order, double lower_bound = 0);

}  // namespace umbilic
