// SPDX-License-Identifier: MIT
/// \file
/// The functionals' places in arrays, and their orders; for kernels as well, which include no library.
#pragma once

namespace umbilic {

enum Functional { kBending, kWillmore, kMvs, kMvsCross, kMehlumTarrou, kSecondFormVariation };
inline constexpr int kFunctionalCount = 6;

/// Third-order functionals integrate squared curvature derivatives and carry the factor area.
constexpr bool is_third_order(int functional) { return functional >= kMvs; }

/// Regularizes the difference of the principal curvatures at umbilics, see densities.h; relative to the norm of II.
/// Changes a density by the order of (eta |II| / (kappa1 - kappa2))^2.
inline constexpr double kUmbilicEta = 1e-6;

}  // namespace umbilic
