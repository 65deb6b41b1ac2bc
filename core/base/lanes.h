// SPDX-License-Identifier: MIT
/// \file
/// Vectors of a few doubles ("lanes"), for arithmetic on several samples at once.
#pragma once

#ifdef __wasm_simd128__
#include <wasm_simd128.h>
#endif

#include "base/kernel_namespace.h"

namespace umbilic {

/// Every array of samples is padded to a multiple of this, whatever the number of lanes.
inline constexpr int kSampleMultiple = 4;

}  // namespace umbilic

namespace umbilic::UMBILIC_KERNELS {

#if defined(__AVX512F__)
inline constexpr int kLaneCount = 8;
#elif defined(__AVX2__)
inline constexpr int kLaneCount = 4;
#else
inline constexpr int kLaneCount = 2;
#endif

/// The compiler's vector type; it brings elementwise + - * / <.
using Lanes = double __attribute__((vector_size(kLaneCount * sizeof(double))));

/// A vector that always divides an array of samples evenly: no longer than kSampleMultiple.
inline constexpr int kShortLaneCount = kLaneCount < kSampleMultiple ? kLaneCount : kSampleMultiple;
using ShortLanes = double __attribute__((vector_size(kShortLaneCount * sizeof(double))));

/// Number of doubles in a Lanes or ShortLanes.
template <class L>
inline constexpr int kCount = sizeof(L) / sizeof(double);

/// The same vector at any address. (std::memcpy would keep the compiler from holding arrays of lanes in registers.)
template <class L>
struct Unaligned {
  using Type __attribute__((aligned(alignof(double)), may_alias)) = L;
};

template <class L = Lanes>
L load_lanes(const double* from) {
  return *reinterpret_cast<const typename Unaligned<L>::Type*>(from);
}

template <class L>
void store_lanes(double* to, L x) {
  *reinterpret_cast<typename Unaligned<L>::Type*>(to) = x;
}

template <class L = Lanes>
L splat(double x) {
  return x - L{};
}

/// So that templates can call sqrt on doubles and on lanes.
inline double sqrt(double x) { return __builtin_sqrt(x); }

template <class L>
requires requires(L x) { x[0]; }
L sqrt(L x) {
#ifdef __wasm_simd128__
  return static_cast<L>(wasm_f64x2_sqrt(x));
#else
  for (int i = 0; i < kCount<L>; ++i) x[i] = __builtin_sqrt(x[i]);
  return x;
#endif
}

template <class L>
double sum_lanes(L x) {
  if constexpr (kCount<L> == 2) return x[0] + x[1];
  double sum = 0;
  for (int i = 0; i < kCount<L>; ++i) sum += x[i];
  return sum;
}

/// Adds the lanes of x together until ShortLanes holds them.
template <class L>
ShortLanes fold(L x) {
  if constexpr (kCount < L >> kShortLaneCount) {
    return __builtin_shufflevector(x, x, 0, 1, 2, 3) + __builtin_shufflevector(x, x, 4, 5, 6, 7);
  } else {
    return x;
  }
}

/// sums[i] = the sum of the lanes of x[i].
template <class L>
void sum_lanes_of_four(const L (&x)[4], double* sums) {
  if constexpr (kCount<L> == 2) {
    store_lanes(sums, __builtin_shufflevector(x[0], x[1], 0, 2) + __builtin_shufflevector(x[0], x[1], 1, 3));
    store_lanes(sums + 2, __builtin_shufflevector(x[2], x[3], 0, 2) + __builtin_shufflevector(x[2], x[3], 1, 3));
  } else {
    const L a = __builtin_shufflevector(x[0], x[1], 0, 4, 2, 6) + __builtin_shufflevector(x[0], x[1], 1, 5, 3, 7);
    const L b = __builtin_shufflevector(x[2], x[3], 0, 4, 2, 6) + __builtin_shufflevector(x[2], x[3], 1, 5, 3, 7);
    store_lanes(sums, __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7));
  }
}

template <class L>
double least_lane(L x) {
  double least = x[0];
  for (int i = 1; i < kCount<L>; ++i) least = x[i] < least ? x[i] : least;
  return least;
}

}  // namespace umbilic::UMBILIC_KERNELS
