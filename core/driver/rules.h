// SPDX-License-Identifier: MIT
/// \file
/// The quadrature rules that runs minimize with and report with.
#pragma once

#include "surface/cap_kind.h"
#include "surface/quadrature.h"

namespace umbilic {

/// The cheapest rules whose errors stay below what a level can gain, from the table that `npm run bench -- quadrature`
/// prints: on a minimizer of MVS_cross, which exploits errors, 4 points per direction do on regular faces, while a
/// cap's blend needs 6, the paper's steep one 16; grading matters where the surface itself is singular (`none`).
constexpr QuadratureRule minimizing_rule(CapKind cap) {
  switch (cap) {
    case CapKind::kNone: return {4, 5, 4};
    case CapKind::kFlat: return {4, 16, 1};
    case CapKind::kSmooth: return {4, 6, 2};
  }
  return {};
}

/// For the second derivatives of the optimizer's metric: the rule of the energy itself, because a coarser one makes
/// many directions along the parametrization look negative. The metric holds the normals of `flat` caps fixed, and
/// needs no more accuracy than that.
constexpr QuadratureRule hessian_rule(CapKind cap) {
  return cap == CapKind::kFlat ? QuadratureRule{4, 8, 1} : minimizing_rule(cap);
}

/// Finer than what was minimized with, so that the difference shows the error.
constexpr QuadratureRule reporting_rule(CapKind cap) {
  switch (cap) {
    case CapKind::kNone: return {7, 7, 8};
    case CapKind::kFlat: return {7, 32, 1};
    case CapKind::kSmooth: return {7, 8, 4};
  }
  return {};
}

}  // namespace umbilic
