// SPDX-License-Identifier: MIT
/// \file
/// Indices and orders of the functionals. Kernels use this file too, so it includes no library.
#pragma once

namespace umbilic {

enum Functional {
  kBending,
  kWillmore,
  kMvs,
  kMvsCross,
  kMehlumTarrou,
  kSecondFormVariation,
  kMeanCurvatureVariation,
  kCurvednessVariation
};
inline constexpr int kFunctionalCount = 8;

/// The density of the parametrization (densities.h), which is not a functional: it says how the patches lie on the
/// surface, not which shape it has. Its weight follows those of the functionals.
inline constexpr int kParametrization = kFunctionalCount;
inline constexpr int kDensityCount = kFunctionalCount + 1;

/// Third-order functionals integrate squares of curvature derivatives.
constexpr bool is_third_order(int functional) { return functional >= kMvs; }

/// The power of the area that a functional has as its factor, which makes it independent of size: densities in
/// 1/length^2 need none, those in 1/length^4 the area, one in 1/length^6 its square.
constexpr int area_power(int functional) {
  return functional == kCurvednessVariation ? 2 : is_third_order(functional) ? 1 : 0;
}
inline constexpr int kAreaPowerCount = 3;

/// area^power; exactly `area` for the power 1.
constexpr double area_to_the(int power, double area) {
  double factor = 1;
  for (; power > 0; --power) factor *= area;
  return factor;
}

/// Which powers of the area occur in a sum of functionals. Power 0 means functionals of second order, the others those
/// of third.
struct AreaPowers {
  bool has[kAreaPowerCount] = {};

  constexpr bool third_order() const {
    for (int power = 1; power < kAreaPowerCount; ++power) {
      if (has[power]) return true;
    }
    return false;
  }
};

/// Regularizes the difference of the principal curvatures at umbilics (densities.h); relative to the norm of II.
/// Changes a density by about (eta |II| / (kappa1 - kappa2))^2, relatively.
inline constexpr double kUmbilicEta = 1e-6;

}  // namespace umbilic
