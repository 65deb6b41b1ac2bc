// SPDX-License-Identifier: MIT
/// \file
/// Indices and orders of the functionals. Kernels use this file too, so it includes no library.
#pragma once

namespace umbilic {

enum Functional { kBending, kWillmore, kMvs, kMvsCross, kMehlumTarrou, kSecondFormVariation };
inline constexpr int kFunctionalCount = 6;

/// The density of the parametrization (densities.h), which is not a functional: it says how the patches lie on the
/// surface, not which shape it has. Its weight follows those of the functionals.
inline constexpr int kParametrization = kFunctionalCount;
inline constexpr int kDensityCount = kFunctionalCount + 1;

/// Third-order functionals integrate squared curvature derivatives and carry the factor area.
constexpr bool is_third_order(int functional) { return functional >= kMvs; }

/// Regularizes the difference of the principal curvatures at umbilics (densities.h); relative to the norm of II.
/// Changes a density by about (eta |II| / (kappa1 - kappa2))^2, relatively.
inline constexpr double kUmbilicEta = 1e-6;

}  // namespace umbilic
