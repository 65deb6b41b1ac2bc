// SPDX-License-Identifier: MIT
/// \file
/// Partial derivatives of order 0 to 3 of functions of (u, v), their fixed order, and the product rule.
#pragma once

#include <Eigen/Core>

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

/// One function's derivatives.
using Derivatives = Eigen::Matrix<double, kDerivativeCount, 1>;

/// Derivatives of several functions, a column each.
using DerivativeRows = Eigen::Matrix<double, kDerivativeCount, Eigen::Dynamic>;

/// Derivatives of f times each function of `rows` (Leibniz).
template <class Rows>
typename Rows::PlainObject product(const Derivatives& f, const Eigen::MatrixBase<Rows>& rows) {
  constexpr int kBinomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  typename Rows::PlainObject result = Rows::PlainObject::Zero(kDerivativeCount, rows.cols());
  for (int d = 0; d < kDerivativeCount; ++d) {
    for (int i = 0; i <= kOrderU[d]; ++i) {
      for (int j = 0; j <= kOrderV[d]; ++j) {
        const double binomial = kBinomial[kOrderU[d]][i] * kBinomial[kOrderV[d]][j];
        result.row(d) +=
            binomial * f[derivative_index(i, j)] * rows.row(derivative_index(kOrderU[d] - i, kOrderV[d] - j));
      }
    }
  }
  return result;
}

}  // namespace umbilic
