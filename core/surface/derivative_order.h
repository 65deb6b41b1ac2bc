// SPDX-License-Identifier: MIT
/// \file
/// The fixed order of the partial derivatives of order 0 to 3 of functions of (u, v).
#pragma once

namespace umbilic {

/// The order everywhere is f, f_u, f_v, f_uu, f_uv, f_vv, f_uuu, f_uuv, f_uvv, f_vvv.
inline constexpr int kDerivativeCount = 10;

/// Number of derivatives of order 1; of order 1 and 2; of order 1 to 3.
inline constexpr int kFirstOrderCount = 2;
inline constexpr int kSecondOrderCount = 5;
inline constexpr int kThirdOrderCount = 9;

/// How many times each derivative differentiates by u and by v.
inline constexpr int kOrderU[kDerivativeCount] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0};
inline constexpr int kOrderV[kDerivativeCount] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};

/// Index of the derivative that differentiates k times by u and l times by v, k + l <= 3.
constexpr int derivative_index(int k, int l) {
  const int order = k + l;
  return order * (order + 1) / 2 + l;
}

}  // namespace umbilic
