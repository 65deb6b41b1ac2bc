// SPDX-License-Identifier: MIT
/// \file
/// The quadrature rules that runs minimize with and report with.
#pragma once

#include "surface/cap_kind.h"
#include "surface/quadrature.h"

namespace umbilic {

/// The cheapest rule whose error stays below what a level can gain; `npm run bench` prints the table that it was chosen
/// from. The steep blend of `flat` needs more samples than the polynomial one.
constexpr QuadratureRule minimizing_rule(CapKind cap) {
  return cap == CapKind::kFlat ? QuadratureRule{4, 16, 1} : QuadratureRule{4, 6, 2};
}

constexpr QuadratureRule reporting_rule(CapKind cap) {
  return cap == CapKind::kFlat ? QuadratureRule{7, 32, 2} : QuadratureRule{7, 10, 6};
}

}  // namespace umbilic
