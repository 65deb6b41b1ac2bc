// SPDX-License-Identifier: MIT
/// \file
/// The quadrature rules that runs minimize with and report with, and when they take finer ones.
#pragma once

#include "energy/functional.h"
#include "surface/cap_kind.h"
#include "surface/quadrature.h"

namespace umbilic {

/// How many steps finer than usual a level's rules may become.
inline constexpr int kFinestRules = 3;

/// Each step divides the error on stretched patches by about ten.
constexpr QuadratureRule finer(const QuadratureRule& rule, CapKind cap, int steps) {
  return {rule.regular_points + 2 * steps, rule.cap_points + (cap == CapKind::kFlat ? 4 : 2) * steps,
          rule.grading + (cap == CapKind::kNone ? steps : 0)};
}

/// The cheapest rules whose errors stay below what a level can gain, from the table that `npm run bench -- quadrature`
/// prints, on minimizers, which exploit errors: on regular faces 4 points per direction for functionals of third order
/// and 6 for those of second, whose minimizers stretch patches farther; 6 for the blend of `smooth` caps and 16 for the
/// steep one of `flat` caps; grading where the surface itself is singular (`none`).
constexpr QuadratureRule minimizing_rule(CapKind cap, const Weights& weights, int steps = 0) {
  const int regular = third_order(weights) ? 4 : 6;
  switch (cap) {
    case CapKind::kNone: return finer({regular, 5, 4}, cap, steps);
    case CapKind::kFlat: return finer({regular, 16, 1}, cap, steps);
    case CapKind::kSmooth: return finer({regular, 6, 2}, cap, steps);
  }
  return {};
}

/// For the second derivatives of the optimizer's metric: the rule of the energy itself, because a coarser one makes
/// many directions along the parametrization look negative. The metric holds the normals of `flat` caps fixed, and
/// needs no more accuracy than that.
constexpr QuadratureRule hessian_rule(CapKind cap, const Weights& weights, int steps = 0) {
  return cap == CapKind::kFlat ? finer({4, 8, 1}, cap, steps) : minimizing_rule(cap, weights, steps);
}

/// Finer than what is usually minimized with, so that the difference shows the error. One for all surfaces, whatever
/// rule they were minimized with, so that whoever evaluates a surface again finds the same energies.
constexpr QuadratureRule reporting_rule(CapKind cap) {
  switch (cap) {
    case CapKind::kNone: return {7, 7, 8};
    case CapKind::kFlat: return {7, 32, 1};
    case CapKind::kSmooth: return {7, 8, 4};
  }
  return {};
}

/// Quadrature errors that a level can live with, relative to what it has gained and to its energy. With caps
/// bending's are at most 1/370 of the gain where the quadrature is good, but 1/26 to 1/4 where patches stretch until
/// curvature hides between the samples. Functionals of third order have up to 1/23 at a sphere's first levels, which
/// finer rules do not improve, and on frames 1/180.
constexpr double harmless_share(const Weights& weights) { return third_order(weights) ? 0.05 : 0.02; }
inline constexpr double kHarmlessError = 1e-4;

/// Whether a level that began with the energy `start`, its own or where that is less the level's before, and has come
/// to `energy`, both by the minimizing rule, and to `reported` by the reporting rule, makes use of the quadrature's
/// error.
constexpr bool exploits_quadrature(const Weights& weights, double start, double energy, double reported) {
  const double error = energy < reported ? reported - energy : energy - reported;
  return error > harmless_share(weights) * (start - reported) && error > kHarmlessError * reported;
}

}  // namespace umbilic
