// SPDX-License-Identifier: MIT
/// \file
/// Tori of revolution in closed form: their energies, and the ratio of radii at which a functional is least among them.
///
/// a = r/R is the radius of the tube divided by that of the circle of its centres. Only one curvature derivative is
/// nonzero: that of the curvature around the axis, along the circles of the tube.
///
/// | functional | torus of ratio a |
/// |---|---|
/// | bending | 4 pi^2 / (a sqrt(1 - a^2)), least at a = 1/sqrt 2: 8 pi^2, the Clifford torus |
/// | willmore | bending / 4, since the Gaussian curvature integrates to 0 |
/// | mvs | 0 |
/// | mvs_cross | 8 pi^4 (1 - a^2)^(-3/2), falls to 8 pi^4 as a -> 0 |
/// | mehlum_tarrou | 9/16 mvs_cross |
/// | second_form_variation | 3 mvs_cross |
/// | mean_curvature_variation | mvs_cross |
/// | curvedness_variation | 8 pi^6 a (1 + 4 a^2) (1 - a^2)^(-7/2), falls to 0 as a -> 0 |
#pragma once

#include <array>

#include "energy/functional.h"

namespace umbilic {

/// All energies of the torus of this ratio, 0 < ratio < 1, in the order of `Functional`.
std::array<double, kFunctionalCount> torus_energies(double ratio);

struct TorusMinimizer {
  /// The ratio of least energy. 0 if the infimum is only approached, by ever thinner tori; NaN if all tori have the
  /// same energy.
  double ratio = 0;
  double energy = 0;     ///< the minimum or infimum
  bool attained = true;  ///< whether a torus has this energy

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("ratio", self.ratio);
    visit("energy", self.energy);
    visit("attained", self.attained);
  }
};

/// The torus of revolution of least energy. `weights` must be usable (energy/functional.h). With weights w1 of bending
/// and w2 of mvs_cross the ratio solves (1 - a^2)(1 - 2 a^2) / (6 pi^2 a^3) = w2/w1, and with w3 of
/// curvedness_variation 6 pi^2 w2 a^3 + 2 pi^4 w3 a^2 (1 + 18 a^2 + 16 a^4)/(1 - a^2)^2 = w1 (1 - a^2)(1 - 2 a^2).
/// Exact to rounding.
TorusMinimizer torus_minimizer(const Weights& weights);

}  // namespace umbilic
