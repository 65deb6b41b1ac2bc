// SPDX-License-Identifier: MIT
/// \file
/// Polynomials in two variables truncated after order 3: what a function of them is near a point, with all its
/// derivatives through order 3.
#pragma once

#include <array>
#include <cmath>

namespace umbilic::opinion {

/// The coefficient of s^k t^l is at index(k, l).
struct Taylor {
  static constexpr int kCount = 10;
  static constexpr int index(int k, int l) { return (k + l) * (k + l + 1) / 2 + l; }

  std::array<double, kCount> c{};

  Taylor() = default;
  Taylor(double constant) { c[0] = constant; }

  /// The variables themselves, times `slope`, around the value `at`.
  static Taylor along_s(double at, double slope) { return linear(at, slope, 0); }
  static Taylor along_t(double at, double slope) { return linear(at, 0, slope); }

  /// The derivative (k, l) at the point.
  double derivative(int k, int l) const {
    constexpr double kFactorial[] = {1, 1, 2, 6};
    return c[index(k, l)] * kFactorial[k] * kFactorial[l];
  }
  /// The derivatives as functions. Their terms of order 3 are lost.
  Taylor by_s() const { return differentiated(1); }
  Taylor by_t() const { return differentiated(0); }

  Taylor& operator+=(const Taylor& o) {
    for (int i = 0; i < kCount; ++i) c[i] += o.c[i];
    return *this;
  }
  friend Taylor operator+(Taylor a, const Taylor& b) { return a += b; }
  friend Taylor operator-(const Taylor& a, const Taylor& b) { return a + b * -1; }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    Taylor product;
    for (int m = 0; m < 4; ++m) {
      for (int k = 0; k <= m; ++k) {
        const int i = index(m - k, k);
        for (int n = 0; m + n < 4; ++n) {
          for (int l = 0; l <= n; ++l) product.c[index(m + n - k - l, k + l)] += a.c[i] * b.c[index(n - l, l)];
        }
      }
    }
    return product;
  }
  friend Taylor operator*(Taylor a, double b) {
    for (double& coefficient : a.c) coefficient *= b;
    return a;
  }
  friend Taylor operator*(double a, const Taylor& b) { return b * a; }

 private:
  static Taylor linear(double at, double slope_s, double slope_t) {
    Taylor x(at);
    x.c[1] = slope_s;
    x.c[2] = slope_t;
    return x;
  }
  Taylor differentiated(int k) const {
    Taylor d;
    for (int m = 0; m < 3; ++m) {
      for (int j = 0; j <= m; ++j) {
        const int i = m - j;
        d.c[index(i, j)] = k == 1 ? (i + 1) * c[index(i + 1, j)] : (j + 1) * c[index(i, j + 1)];
      }
    }
    return d;
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
inline Taylor exp(const Taylor& x) {
  const double e = std::exp(x.c[0]);
  return compose(x, e, e, e, e);
}
inline Taylor sin(const Taylor& x) {
  const double s = std::sin(x.c[0]), c = std::cos(x.c[0]);
  return compose(x, s, c, -s, -c);
}
inline Taylor cos(const Taylor& x) {
  const double s = std::sin(x.c[0]), c = std::cos(x.c[0]);
  return compose(x, c, -s, -c, s);
}

/// A point of a surface near a parameter.
using TaylorPoint = std::array<Taylor, 3>;

inline TaylorPoint operator+(const TaylorPoint& a, const TaylorPoint& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline TaylorPoint operator-(const TaylorPoint& a, const TaylorPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline TaylorPoint operator*(const TaylorPoint& a, const Taylor& b) { return {a[0] * b, a[1] * b, a[2] * b}; }
inline Taylor dot(const TaylorPoint& a, const TaylorPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline TaylorPoint cross(const TaylorPoint& a, const TaylorPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace umbilic::opinion
