// SPDX-License-Identifier: MIT
/// \file
/// Bivariate Taylor polynomials truncated after order 3, and jets of surfaces given by formulas in them.
#pragma once

#include <array>
#include <cmath>

#include "energy/curvature.h"
#include "surface/derivatives.h"

namespace umbilic::test {

/// Coefficients of s^k t^l at derivative_index(k, l).
struct Taylor {
  std::array<double, kDerivativeCount> c{};

  Taylor() = default;
  Taylor(double constant) { c[0] = constant; }

  Taylor& operator+=(const Taylor& o) {
    for (int i = 0; i < kDerivativeCount; ++i) c[i] += o.c[i];
    return *this;
  }
  friend Taylor operator+(Taylor a, const Taylor& b) { return a += b; }
  friend Taylor operator-(const Taylor& a, const Taylor& b) { return a + b * -1; }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    Taylor product;
    for (int i = 0; i < kDerivativeCount; ++i) {
      for (int j = 0; j < kDerivativeCount; ++j) {
        const int k = kOrderU[i] + kOrderU[j], l = kOrderV[i] + kOrderV[j];
        if (k + l <= 3) product.c[derivative_index(k, l)] += a.c[i] * b.c[j];
      }
    }
    return product;
  }

  /// The derivative (k, l).
  double derivative(int k, int l) const {
    constexpr double kFactorial[] = {1, 1, 2, 6};
    return c[derivative_index(k, l)] * kFactorial[k] * kFactorial[l];
  }
};

/// f(x) from the derivatives of f at the constant part of x.
inline Taylor compose(const Taylor& x, double f0, double f1, double f2, double f3) {
  Taylor d = x;
  d.c[0] = 0;
  return f0 + d * (f1 + d * (f2 / 2 + d * (f3 / 6)));
}

inline Taylor pow(const Taylor& x, double p) {
  const double a = x.c[0], f = std::pow(a, p);
  return compose(x, f, p * f / a, p * (p - 1) * f / (a * a), p * (p - 1) * (p - 2) * f / (a * a * a));
}
inline Taylor sqrt(const Taylor& x) { return pow(x, 0.5); }
inline Taylor sin(const Taylor& x) {
  const double s = std::sin(x.c[0]), c = std::cos(x.c[0]);
  return compose(x, s, c, -s, -c);
}
inline Taylor cos(const Taylor& x) {
  const double s = std::sin(x.c[0]), c = std::cos(x.c[0]);
  return compose(x, c, -s, -c, s);
}

using TaylorPoint = std::array<Taylor, 3>;

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
