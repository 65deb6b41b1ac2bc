// SPDX-License-Identifier: MIT
/// \file
/// Which metric a level takes where that is left open.
#pragma once

#include "problem/metric_choice.h"

namespace umbilic {

/// Most unknowns of a level that the automatic choice gives the Hessian's metric.
inline constexpr int kMostHessianUnknowns = 8000;

/// The metric that is measured to be faster. The Hessian converges in a tenth of the evaluations, but its cost grows
/// faster with the number of unknowns. So it does not pay for large surfaces without symmetry, which have more patches
/// per unknown; and for functionals of second order, which converge well in any metric, it pays only with symmetry.
/// Newton's is for surfaces whose parametrization is free, as no symmetry holds it: there the Hessian creeps.
constexpr MetricChoice metric_for_level(MetricChoice asked, bool third_order, int symmetry_order, double unknowns) {
  constexpr int kMostOfSecondOrder = 2000;
  if (asked != MetricChoice::kAutomatic) return asked;
  const bool symmetric = symmetry_order > 1;
  const int most = third_order ? kMostHessianUnknowns : symmetric ? kMostOfSecondOrder : 0;
  if (unknowns == 0 || unknowns > most) return MetricChoice::kSobolev;
  return symmetric ? MetricChoice::kHessian : MetricChoice::kNewton;
}

}  // namespace umbilic
