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
  double energy = 0;           ///< second + area_factor * third
  double second = 0;           ///< weighted integral of the second-order densities
  double parametrization = 0;  ///< weighted integral of the parametrization's density, which `energy` leaves out
  double third = 0;            ///< weighted integral of the third-order densities, without the factor area
  double area = 0;
  double area_factor = 0;  ///< the area, or the constant that replaces it
  double area_slope = 0;   ///< derivative of the energy by the area: `third`, or 0 if the factor is a constant
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

  /// Also gives the gradients of `EnergyValue::third` and `area`, control_count x 3. The energy must contain their
  /// product.
  EnergyValue evaluate_factors(const Points& control, Points& third, Points& area) const;

  const PatchLayout& layout() const { return jets_.layout(); }
  const Weights& weights() const { return weights_; }
  /// Whether some functional of third order has a nonzero weight.
  bool third_order() const { return third_order_; }
  /// Whether it contains the product of the area and a third-order integral.
  bool has_area_product() const { return third_order_ && !fixed_area_; }

 private:
  EnergyValue evaluate_channels(const Points& control, double parametrization, bool gradient,
                                std::vector<Points>& gradients) const;

  const JetEvaluator& jets_;
  Weights weights_;
  std::optional<double> fixed_area_;
  bool second_order_, third_order_;
  mutable std::vector<BlockEnergies> blocks_;  // summed in their order
  mutable std::vector<Points> gradients_;      // those of the second-order integral, the third-order one and the area
};

struct SurfaceIntegrals {
  std::array<double, kFunctionalCount> functionals{};  ///< third-order ones include the factor area
  double parametrization = 0;                          ///< integral of the parametrization's density
  double area = 0;
  double gaussian = 0;  ///< integral of the Gaussian curvature
};

/// All integrals of a surface by the rule of `jets`.
SurfaceIntegrals surface_integrals(const JetEvaluator& jets, const Points& control);

}  // namespace umbilic
