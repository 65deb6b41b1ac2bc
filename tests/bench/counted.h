// SPDX-License-Identifier: MIT
/// \file
/// A number that counts the operations done with it, for the templates of curvature and densities.
#pragma once

namespace umbilic {

struct Counted {
  double value = 0;
  static inline long operations = 0;  ///< additions, multiplications, divisions and roots

  Counted() = default;
  Counted(double v) : value(v) {}

  static Counted result(double v) {
    ++operations;
    return v;
  }
  Counted& operator+=(const Counted& o) { return *this = *this + o; }
  Counted& operator-=(const Counted& o) { return *this = *this - o; }
  friend Counted operator-(const Counted& a) { return -a.value; }
  friend Counted operator+(const Counted& a, const Counted& b) { return result(a.value + b.value); }
  friend Counted operator-(const Counted& a, const Counted& b) { return result(a.value - b.value); }
  friend Counted operator*(const Counted& a, const Counted& b) { return result(a.value * b.value); }
  friend Counted operator/(const Counted& a, const Counted& b) { return result(a.value / b.value); }
  friend Counted sqrt(const Counted& a) { return result(__builtin_sqrt(a.value)); }
};

}  // namespace umbilic
