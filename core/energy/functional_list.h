// SPDX-License-Identifier: MIT
/// \file
/// The functionals' places in arrays, and their orders; for kernels as well, which include no library.
#pragma once

namespace umbilic {

enum Functional { kBending, kWillmore, kMvs, kMvsCross, kMehlumTarrou, kSecondFormVariation };
inline constexpr int kFunctionalCount = 6;

/// Third-order functionals integrate squared curvature derivatives and carry the factor area.
constexpr bool is_third_order(int functional) { return functional >= kMvs; }

}  // namespace umbilic
