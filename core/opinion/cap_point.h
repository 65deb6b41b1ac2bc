// SPDX-License-Identifier: MIT
/// \file
/// A point of a cap from the points of S and of the characteristic map.
#pragma once

#include "base/types.h"
#include "opinion/taylor.h"

namespace umbilic::opinion {

/// 1 at t = 0 and 0 at t = 1 with three derivatives: 1 - (35 t^4 - 84 t^5 + 70 t^6 - 20 t^7).
inline Taylor smooth_blend(const Taylor& t) {
  const Taylor square = t * t;
  return 1.0 - square * square * (35.0 + t * (-84.0 + t * (70.0 - 20.0 * t)));
}

/// Joshi & Sequin's eq. 8, h(t) / (h(t) + h(1 - t)) with h(t) = exp(2 exp(-1/t) / (t - 1)).
inline Taylor flat_blend(const Taylor& t) {
  constexpr double kRounded = 1e-3;  // nearer to the ends it is 1 and 0 to the last bit
  if (t.c[0] < kRounded) return 1;
  if (t.c[0] > 1 - kRounded) return 0;
  const auto h = [](const Taylor& x) { return exp(2 * exp(-1 * pow(x, -1)) * pow(x - 1, -1)); };
  const Taylor here = h(t), there = h(1 - t);
  return here * pow(here + there, -1);
}

/// The polynomial with the coefficients of x^(k-l) y^l, sorted by k, then l.
inline TaylorPoint polynomial(const Points& coefficients, int degree, const Taylor& x, const Taylor& y) {
  TaylorPoint sum{};
  for (int k = degree; k >= 0; --k) {  // by powers of y, each with a polynomial in x, by Horner
    TaylorPoint row{};
    for (int m = degree; m >= k; --m) {  // the coefficient of x^(m-k) y^k
      const int i = m * (m + 1) / 2 + k;
      for (int c = 0; c < 3; ++c) row[c] = row[c] * x + coefficients(i, c);
    }
    for (int c = 0; c < 3; ++c) sum[c] = sum[c] * y + row[c];
  }
  return sum;
}

}  // namespace umbilic::opinion
