// SPDX-License-Identifier: MIT
/// \file
/// The fixed order of the partial derivatives of order 0 to 3 of functions of (u, v).
#pragma once

namespace umbilic {

/// Everywhere in the order f, f_u, f_v, f_uu, f_uv, f_vv, f_uuu, f_uuv, f_uvv, f_vvv.
inline constexpr int kDerivativeCount = 10;

/// Derivatives through order 1 and 2 that a functional needs besides the position.
inline constexpr int kFirstOrderCount = 2;
inline constexpr int kSecondOrderCount = 5;
inline constexpr int kThirdOrderCount = 9;

/// How often the derivative at each place differentiates by u and by v.
inline constexpr int kOrderU[kDerivativeCount] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0};
inline constexpr int kOrderV[kDerivativeCount] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};

/// The place of the derivative by u `k` times and by v `l` times, k + l <= 3.
constexpr int derivative_index(int k, int l) {
  const int order = k + l;
  return order * (order + 1) / 2 + l;
}

}  // namespace umbilic
