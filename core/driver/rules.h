// SPDX-License-Identifier: MIT
/// \file
/// The quadrature rules that runs minimize with and report with.
#pragma once

#include "energy/functional.h"
#include "surface/cap_kind.h"
#include "surface/quadrature.h"

namespace umbilic {

/// The cheapest rules whose errors stay below what a level can gain, from the table that `npm run bench -- quadrature`
/// prints, on minimizers, which exploit errors: on regular faces 4 points per direction for functionals of third order
/// and 6 for those of second, whose minimizers stretch patches farther; 6 for the blend of `smooth` caps and 16 for the
/// steep one of `flat` caps; grading where the surface itself is singular (`none`).
constexpr QuadratureRule minimizing_rule(CapKind cap, const Weights& weights) {
  const int regular = third_order(weights) ? 4 : 6;
  switch (cap) {
    case CapKind::kNone: return {regular, 5, 4};
    case CapKind::kFlat: return {regular, 16, 1};
    case CapKind::kSmooth: return {regular, 6, 2};
  }
  return {};
}

/// For the second derivatives of the optimizer's metric: the rule of the energy itself, because a coarser one makes
/// many directions along the parametrization look negative. The metric holds the normals of `flat` caps fixed, and
/// needs no more accuracy than that.
constexpr QuadratureRule hessian_rule(CapKind cap, const Weights& weights) {
  return cap == CapKind::kFlat ? QuadratureRule{4, 8, 1} : minimizing_rule(cap, weights);
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
