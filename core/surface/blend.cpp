// SPDX-License-Identifier: MIT
/// \file
/// Evaluates the blend functions and their derivatives by truncated Taylor arithmetic.
#include "surface/blend.h"

#include <cmath>

namespace umbilic {
namespace {

/// f(x(t)) from f's derivatives at x(t) (Faa di Bruno through order 3).
Derivatives1 compose(const Derivatives1& f, const Derivatives1& x) {
  return {f[0], f[1] * x[1], f[2] * x[1] * x[1] + f[1] * x[2],
          f[3] * x[1] * x[1] * x[1] + 3 * f[2] * x[1] * x[2] + f[1] * x[3]};
}

Derivatives1 multiply(const Derivatives1& a, const Derivatives1& b) {
  return {a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2 * a[1] * b[1] + a[0] * b[2],
          a[3] * b[0] + 3 * a[2] * b[1] + 3 * a[1] * b[2] + a[0] * b[3]};
}

Derivatives1 reciprocal(double x) { return {1 / x, -1 / (x * x), 2 / (x * x * x), -6 / (x * x * x * x)}; }

/// log h(t) = 2 exp(-1/t) / (t - 1), for 0 < t < 1.
Derivatives1 log_h(double t) {
  const Derivatives1 r = reciprocal(t);
  const double e = std::exp(-r[0]);
  const Derivatives1 decay = compose({e, e, e, e}, -r);
  return 2 * multiply(decay, reciprocal(t - 1));
}

/// 1 / (1 + exp(x)) and its derivatives, accurate both near 0 and near 1.
Derivatives1 falling_logistic(double x) {
  const double small = std::exp(-std::abs(x));
  const double sigma = x > 0 ? small / (1 + small) : 1 / (1 + small);  // the value
  const double slope = -small / ((1 + small) * (1 + small));           // -sigma (1 - sigma)
  return {sigma, slope, slope * (2 * sigma - 1), slope * (1 - 6 * sigma * (1 - sigma))};
}

}  // namespace

Derivatives1 paper_blend(double t) {
  if (1 - t >= 1) return {1, 0, 0, 0};
  if (t >= 1) return {0, 0, 0, 0};
  const Derivatives1 here = log_h(t);
  Derivatives1 mirrored = log_h(1 - t);
  mirrored[1] = -mirrored[1];
  mirrored[3] = -mirrored[3];
  const Derivatives1 x = mirrored - here;
  const Derivatives1 f = falling_logistic(x[0]);
  if (f[1] == 0) return {f[0], 0, 0, 0};
  return compose(f, x);
}

Derivatives1 smoothstep_blend(double t) {
  if (t <= 0) return {1, 0, 0, 0};
  if (t >= 1) return {0, 0, 0, 0};
  const double s = 1 - t;
  return {s * s * s * s * (1 + 4 * t + 10 * t * t + 20 * t * t * t), -140 * t * t * t * s * s * s,
          -420 * t * t * s * s * (1 - 2 * t), -840 * t * s * (1 - 5 * t * s)};
}

Derivatives tensor_blend(Derivatives1 (*f)(double), double u, double v, double scale) {
  Derivatives1 along_u = f(u / scale), along_v = f(v / scale);
  for (int k = 1, power = 1; k < 4; ++k) {
    power *= static_cast<int>(scale);
    along_u[k] /= power;
    along_v[k] /= power;
  }
  Derivatives result;
  for (int d = 0; d < kDerivativeCount; ++d) result[d] = along_u[kOrderU[d]] * along_v[kOrderV[d]];
  return result;
}

}  // namespace umbilic
