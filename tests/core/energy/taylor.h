// SPDX-License-Identifier: MIT
/// \file
/// Jets of surfaces given by formulas in truncated Taylor polynomials.
#pragma once

#include "energy/curvature.h"
#include "opinion/taylor.h"

namespace umbilic::test {

using opinion::Taylor;
using opinion::TaylorPoint;

inline Jet<double> jet_of(const TaylorPoint& x) {
  const auto at = [&](int k, int l) {
    return Vec3<double>{x[0].derivative(k, l), x[1].derivative(k, l), x[2].derivative(k, l)};
  };
  return {{at(1, 0), at(0, 1)}, {at(2, 0), at(1, 1), at(0, 2)}, {at(3, 0), at(2, 1), at(1, 2), at(0, 3)}};
}

/// Parameters as functions of (s, t) at the origin: a skewed, curved, orientation-keeping reparametrization.
struct Parameters {
  Taylor u, v;
};

inline Parameters curved_parameters(double u, double v) {
  Parameters result{u, v};
  result.u.c = {u, 0.8, -0.5, 0.3, -0.7, 0.2, 0.4, 0.1, -0.6, 0.25};
  result.v.c = {v, 0.3, 1.1, -0.4, 0.5, 0.6, -0.2, 0.35, 0.15, -0.45};
  return result;
}

}  // namespace umbilic::test
