// SPDX-License-Identifier: MIT
/// \file
/// The quadrature rules for minimizing and for reporting, and when to refine them.
#pragma once

#include "energy/functional.h"
#include "surface/cap_kind.h"
#include "surface/quadrature.h"

namespace umbilic {

/// Largest number of steps by which a level's rules are refined.
inline constexpr int kFinestRules = 3;

/// Each step divides the error on stretched patches by about ten.
constexpr QuadratureRule finer(const QuadratureRule& rule, CapKind cap, int steps) {
  return {rule.regular_points + 2 * steps, rule.cap_points + (cap == CapKind::kFlat ? 4 : 2) * steps,
          rule.grading + (cap == CapKind::kNone ? steps : 0)};
}

/// The cheapest rules whose errors stay below what a level can gain, from the table of `npm run bench -- quadrature`
/// (on minimizers, which exploit errors). On regular faces 4 points per direction for functionals of third order, and 6
/// for those of second, whose minimizers stretch patches more; 6 for the blend of `smooth` caps and 16 for the steep
/// one of `flat` caps; grading if the surface itself is singular (`none`).
constexpr QuadratureRule minimizing_rule(CapKind cap, const Weights& weights, int steps = 0) {
  const int regular = third_order(weights) ? 4 : 6;
  switch (cap) {
    case CapKind::kNone: return finer({regular, 5, 4}, cap, steps);
    case CapKind::kFlat: return finer({regular, 16, 1}, cap, steps);
    case CapKind::kSmooth: return finer({regular, 6, 2}, cap, steps);
  }
  return {};
}

/// The rule for the second derivatives in the optimizer's metric: the rule of the energy itself, since with a coarser
/// one many directions along the parametrization look negative. The metric holds the normals of `flat` caps fixed, so
/// it needs no higher accuracy for these.
constexpr QuadratureRule hessian_rule(CapKind cap, const Weights& weights, int steps = 0) {
  return cap == CapKind::kFlat ? finer({4, 8, 1}, cap, steps) : minimizing_rule(cap, weights, steps);
}

/// The rule for reports. It is finer than the minimizing rule, so that the difference shows the error. It does not
/// depend on how the surface was minimized, so that evaluating a surface again gives the same energies.
constexpr QuadratureRule reporting_rule(CapKind cap) {
  switch (cap) {
    case CapKind::kNone: return {7, 7, 8};
    case CapKind::kFlat: return {7, 32, 1};
    case CapKind::kSmooth: return {7, 8, 4};
  }
  return {};
}

/// Acceptable quadrature errors, relative to what a level has gained and to its energy. With caps, those of bending are
/// at most 1/370 of the gain if the quadrature is good, but 1/26 to 1/4 if patches stretch until the samples miss
/// curvature. Functionals of third order have up to 1/23 at a sphere's first levels, which finer rules do not improve,
/// and 1/180 on frames.
constexpr double harmless_share(const Weights& weights) { return third_order(weights) ? 0.05 : 0.02; }
inline constexpr double kHarmlessError = 1e-4;

/// Whether a level exploits the quadrature error. `start` is the energy at which it began, or that of the level before
/// if smaller; `energy` is its current one, both by the minimizing rule; `reported` is the current energy by the
/// reporting rule.
///
/// A run that goes on from a surface measures what it gains from there, which may be little where it had been minimized
/// already. So it may take a finer rule than a run without interruption, and then the energies by the minimizing rules
/// differ by the coarser rule's error; the surfaces, and the reported energies, are the same but for what that rule
/// misses.
constexpr bool exploits_quadrature(const Weights& weights, double start, double energy, double reported) {
  const double error = energy < reported ? reported - energy : energy - reported;
  return error > harmless_share(weights) * (start - reported) && error > kHarmlessError * reported;
}

}  // namespace umbilic
