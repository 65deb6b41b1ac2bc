// SPDX-License-Identifier: MIT
/// \file
/// Partial derivatives of order 0 to 3 of functions of (u, v) as matrices, and the product rule.
#pragma once

#include <Eigen/Core>

#include "surface/derivative_order.h"

namespace umbilic {

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
