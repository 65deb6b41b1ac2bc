// SPDX-License-Identifier: MIT
/// \file
/// The graph of a generic polynomial: principal curvatures from the textbook formulas, in extended precision, to be
/// differenced.
#pragma once

#include <array>
#include <cmath>

#include "energy/taylor.h"

namespace umbilic::test {

using Real = long double;

/// z = f(x, y) of degree 5.
struct Graph {
  struct Height {
    Real x, y, xx, xy, yy;  ///< derivatives
  };

  template <class T>
  static T height(const T& x, const T& y) {
    return x * (x * 0.7 - y * 0.4) + y * y * -0.5 + x * x * (x * 0.3 + y * 0.8) + y * y * (y * 0.45 - x * 0.6) +
           x * x * x * (x * 0.2 - y * 0.35) + x * y * y * (x * 0.5 + y * 0.15) + x * x * y * y * y * 0.25;
  }

  static Height derivatives(Real x, Real y) {
    return {1.4L * x - 0.4L * y + 0.9L * x * x + 1.6L * x * y - 0.6L * y * y + 0.8L * x * x * x - 1.05L * x * x * y +
                x * y * y + 0.15L * y * y * y + 0.5L * x * y * y * y,
            -0.4L * x - y + 0.8L * x * x + 1.35L * y * y - 1.2L * x * y - 0.35L * x * x * x + x * x * y +
                0.45L * x * y * y + 0.75L * x * x * y * y,
            1.4L + 1.8L * x + 1.6L * y + 2.4L * x * x - 2.1L * x * y + y * y + 0.5L * y * y * y,
            -0.4L + 1.6L * x - 1.2L * y - 1.05L * x * x + 2 * x * y + 0.45L * y * y + 1.5L * x * y * y,
            -1 + 2.7L * y - 1.2L * x + x * x + 0.9L * x * y + 1.5L * x * x * y};
  }

  static TaylorPoint point(const Taylor& x, const Taylor& y) { return {x, y, height(x, y)}; }
};

struct FundamentalForms {
  Real e, f, g, l, m, n;
};

inline FundamentalForms forms(Real x, Real y) {
  const Graph::Height h = Graph::derivatives(x, y);
  const Real w = std::sqrt(1 + h.x * h.x + h.y * h.y);
  return {1 + h.x * h.x, h.x * h.y, 1 + h.y * h.y, h.xx / w, h.xy / w, h.yy / w};
}

/// kappa1 >= kappa2.
inline std::array<Real, 2> principal_curvatures(Real x, Real y) {
  const auto [e, f, g, l, m, n] = forms(x, y);
  const Real det = e * g - f * f, mean = (e * n - 2 * f * m + g * l) / (2 * det), gauss = (l * n - m * m) / det;
  const Real deviation = std::sqrt(mean * mean - gauss);
  return {mean + deviation, mean - deviation};
}

/// The unit tangent vector, in parameters, along which the normal curvature is `kappa`.
inline std::array<Real, 2> principal_direction(Real x, Real y, Real kappa) {
  const auto [e, f, g, l, m, n] = forms(x, y);
  const Real a = l - kappa * e, b = m - kappa * f, c = n - kappa * g;
  std::array<Real, 2> d = std::abs(a) > std::abs(c) ? std::array{-b, a} : std::array{-c, b};
  const Real length = std::sqrt(e * d[0] * d[0] + 2 * f * d[0] * d[1] + g * d[1] * d[1]);
  return {d[0] / length, d[1] / length};
}

/// f'(0), central differences with the errors h^2, h^4, h^6 removed.
template <class F>
Real slope(const F& f) {
  const auto central = [&](Real h) { return (f(h) - f(-h)) / (2 * h); };
  const Real h = 4e-3L;
  Real d[4] = {central(h), central(h / 2), central(h / 4), central(h / 8)};
  for (int order = 1; order < 4; ++order) {
    for (int i = 0; i + order < 4; ++i) d[i] = d[i + 1] + (d[i + 1] - d[i]) / (std::pow(4.0L, order) - 1);
  }
  return d[0];
}

}  // namespace umbilic::test
