// SPDX-License-Identifier: MIT
/// \file
/// A few doubles side by side, for arithmetic over several samples at once.
#pragma once

#include <cmath>
#include <cstring>

namespace umbilic {

#if defined(__AVX2__)
inline constexpr int kLaneCount = 4;
#else
inline constexpr int kLaneCount = 2;
#endif

/// Elementwise + - * / come with the compiler's vector type.
using Lanes = double __attribute__((vector_size(kLaneCount * sizeof(double))));

inline Lanes load_lanes(const double* from) {
  Lanes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

inline void store_lanes(double* to, Lanes x) { std::memcpy(to, &x, sizeof x); }

inline Lanes splat(double x) {
  Lanes result;
  for (int i = 0; i < kLaneCount; ++i) result[i] = x;
  return result;
}

/// For templates over double and Lanes.
inline double sqrt(double x) { return std::sqrt(x); }

inline Lanes sqrt(Lanes x) {
  for (int i = 0; i < kLaneCount; ++i) x[i] = std::sqrt(x[i]);
  return x;
}

inline double sum_lanes(Lanes x) {
  double sum = 0;
  for (int i = 0; i < kLaneCount; ++i) sum += x[i];
  return sum;
}

}  // namespace umbilic
