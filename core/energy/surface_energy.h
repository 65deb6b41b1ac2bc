// SPDX-License-Identifier: MIT
/// \file
/// A weighted functional of the whole surface, with its gradient by the control points; and all functionals at once,
/// for reports.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "energy/energy_kernels.h"
#include "energy/functional.h"
#include "surface/jets.h"

namespace umbilic {

struct EnergyValue {
  double energy = 0;  ///< sum of area_factor^p * integrals[p]
  /// [p]: weighted integral of the densities whose functionals have the factor area^p, without that factor.
  std::array<double, kAreaPowerCount> integrals{};
  double parametrization = 0;  ///< weighted integral of the parametrization's density, which `energy` leaves out
  double area = 0;
  double area_factor = 0;  ///< the area, or the constant that replaces it
  double area_slope = 0;   ///< derivative of the energy by area_factor, or 0 if that is a constant
  double gaussian = 0;     ///< integral of the Gaussian curvature
  /// Smallest |X_u x X_v| divided by its mean. Tends to 0 when a patch collapses or folds.
  double regularity = 0;
};

/// Reuses its working memory between evaluations, so there may be only one at a time. Each is shared among threads.
class SurfaceEnergy {
 public:
  /// `jets` must outlive the energy. `fixed_area` replaces the factor area of third-order functionals, if given. That
  /// is for surfaces whose size is held: with their own area, what is held would pull on what is free to make it
  /// smaller.
  SurfaceEnergy(const JetEvaluator& jets, const Weights& weights, std::optional<double> fixed_area = {});

  /// `parametrization` is the weight of the parametrization's density (densities.h); the gradient is that of the energy
  /// plus its term. The result is not finite if the surface is not regular. `gradient`, if given, is control_count x 3.
  EnergyValue evaluate(const Points& control, Points* gradient, double parametrization = 0) const;

  /// Also gives the two factors of the Hessian's term slope area^T + area slope^T that no sum over patches has, both
  /// control_count x 3: the gradient of the area, and that of the energy's derivative by the area as it changes with
  /// the integrals and, by half, with the area: slope = sum of p area^(p-1) grad I_p + 1/2 p (p-1) area^(p-2) I_p grad
  /// area. The energy must contain a product with the area.
  EnergyValue evaluate_factors(const Points& control, Points& slope, Points& area) const;

  const PatchLayout& layout() const { return jets_.layout(); }
  const Weights& weights() const { return weights_; }
  /// Whether some functional of third order has a nonzero weight.
  bool third_order() const { return powers_.third_order(); }
  /// Whether it contains a product of a power of the area and a third-order integral.
  bool has_area_product() const { return third_order() && !fixed_area_; }

 private:
  EnergyValue evaluate_channels(const Points& control, double parametrization, bool gradient,
                                std::vector<Points>& gradients) const;

  const JetEvaluator& jets_;
  Weights weights_;
  std::optional<double> fixed_area_;
  AreaPowers powers_;
  mutable std::vector<BlockEnergies> blocks_;  // summed in their order
  mutable std::vector<Points> gradients_;      // those of the integrals in use, by rising power, and of the area
};

struct SurfaceIntegrals {
  std::array<double, kFunctionalCount> functionals{};  ///< with their powers of the area
  /// With their powers of the area, and with II positive where the surface bends away from its normal.
  std::array<double, kInvariantCount> invariants{};
  double parametrization = 0;  ///< integral of the parametrization's density
  double area = 0;
  double gaussian = 0;  ///< integral of the Gaussian curvature
};

/// All integrals of a surface by the rule of `jets`.
SurfaceIntegrals surface_integrals(const JetEvaluator& jets, const Points& control);

}  // namespace umbilic
