// SPDX-License-Identifier: MIT
/// \file
/// Dual numbers with several tangents (forward differentiation), over doubles or lanes, for the templates of curvature
/// and densities.
#pragma once

#include "base/lanes.h"

namespace umbilic::UMBILIC_KERNELS {

/// A value with its derivatives along kTangents directions.
template <class T, int kTangents>
struct DualNumber {
  T value{};
  T tangent[kTangents]{};

  DualNumber() = default;
  explicit DualNumber(const T& constant) : value(constant) {}

  DualNumber& operator+=(const DualNumber& o) { return *this = *this + o; }
  DualNumber& operator-=(const DualNumber& o) { return *this = *this - o; }

  friend DualNumber operator-(const DualNumber& a) {
    return combine(-a.value, [&](int i) { return -a.tangent[i]; });
  }
  friend DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    return combine(a.value + b.value, [&](int i) { return a.tangent[i] + b.tangent[i]; });
  }
  friend DualNumber operator-(const DualNumber& a, const DualNumber& b) {
    return combine(a.value - b.value, [&](int i) { return a.tangent[i] - b.tangent[i]; });
  }
  friend DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    return combine(a.value * b.value, [&](int i) { return a.tangent[i] * b.value + a.value * b.tangent[i]; });
  }
  friend DualNumber operator+(const DualNumber& a, double b) {
    DualNumber sum = a;
    sum.value += b;
    return sum;
  }
  friend DualNumber operator+(double a, const DualNumber& b) { return b + a; }
  friend DualNumber operator*(double a, const DualNumber& b) {
    return combine(a * b.value, [&](int i) { return a * b.tangent[i]; });
  }
  friend DualNumber operator*(const DualNumber& a, double b) { return b * a; }
  friend DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    const T inverse = 1.0 / b.value, quotient = a.value * inverse;
    return combine(quotient, [&](int i) { return (a.tangent[i] - quotient * b.tangent[i]) * inverse; });
  }
  friend DualNumber operator/(double a, const DualNumber& b) {
    const T inverse = 1.0 / b.value, quotient = a * inverse, slope = -quotient * inverse;
    return combine(quotient, [&](int i) { return slope * b.tangent[i]; });
  }
  friend DualNumber sqrt(const DualNumber& a) {
    const T root = umbilic::sqrt(a.value), slope = 0.5 / root;
    return combine(root, [&](int i) { return slope * a.tangent[i]; });
  }

 private:
  template <class Tangent>
  static DualNumber combine(const T& value, const Tangent& tangent) {
    DualNumber result(value);
    for (int i = 0; i < kTangents; ++i) result.tangent[i] = tangent(i);
    return result;
  }
};

}  // namespace umbilic::UMBILIC_KERNELS
