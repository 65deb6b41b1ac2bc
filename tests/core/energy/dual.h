// SPDX-License-Identifier: MIT
/// \file
/// Forward dual numbers x + dx e, e^2 = 0.
#pragma once

#include <cmath>

namespace umbilic::test {

struct Dual {
  double x = 0, dx = 0;

  Dual() = default;
  Dual(double value, double derivative = 0) : x(value), dx(derivative) {}

  Dual& operator+=(const Dual& o) { return *this = *this + o; }
  Dual& operator-=(const Dual& o) { return *this = *this - o; }
  friend Dual operator-(const Dual& a) { return {-a.x, -a.dx}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.x + b.x, a.dx + b.dx}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.x - b.x, a.dx - b.dx}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.x * b.x, a.dx * b.x + a.x * b.dx}; }
  friend Dual operator/(const Dual& a, const Dual& b) { return {a.x / b.x, (a.dx - a.x / b.x * b.dx) / b.x}; }
};

inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.x);
  return {root, a.dx / (2 * root)};
}

}  // namespace umbilic::test
