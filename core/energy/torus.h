// SPDX-License-Identifier: MIT
/// \file
/// The torus of revolution in closed form: its energies, and the ratio of radii that minimizes a functional among all
/// of them.
///
/// Of the derivatives of its curvatures only one does not vanish, that of the curvature around the axis along the
/// circles of the tube. With a = r/R, the tube's radius over that of the circle of its centres:
///
/// | functional | torus of ratio a |
/// |---|---|
/// | bending | 4 pi^2 / (a sqrt(1 - a^2)), least at a = 1/sqrt 2: 8 pi^2, the Clifford torus |
/// | willmore | bending / 4, since the Gaussian curvature integrates to 0 |
/// | mvs | 0 |
/// | mvs_cross | 8 pi^4 (1 - a^2)^(-3/2), falls to 8 pi^4 as a -> 0 |
/// | mehlum_tarrou | 9/16 mvs_cross |
/// | second_form_variation | 3 mvs_cross |
#pragma once

#include <array>

#include "energy/functional.h"

namespace umbilic {

/// All energies of the torus with this ratio in (0, 1), in the order of `Functional`.
std::array<double, kFunctionalCount> torus_energies(double ratio);

struct TorusMinimizer {
  /// The ratio of least energy; 0 where thinner and thinner tori approach the infimum, NaN where all have the same.
  double ratio = 0;
  double energy = 0;     ///< least, or its infimum
  bool attained = true;  ///< whether a torus has this energy

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    visit("ratio", self.ratio);
    visit("energy", self.energy);
    visit("attained", self.attained);
  }
};

/// The torus of revolution of least energy. `weights` are usable (energy/functional.h). With weights w1 of bending and
/// w2 of mvs_cross the ratio solves (1 - a^2)(1 - 2 a^2) / (6 pi^2 a^3) = w2/w1; it is exact to rounding.
TorusMinimizer torus_minimizer(const Weights& weights);

}  // namespace umbilic
