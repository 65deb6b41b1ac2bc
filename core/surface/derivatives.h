// SPDX-License-Identifier: MIT
/// \file
/// Partial derivatives of order 0 to 3 of functions of (u, v) as matrices, and the product rule.
#pragma once

#include <Eigen/Core>
#include <array>

#include "surface/derivative_order.h"

namespace umbilic {

/// One function's derivatives.
using Derivatives = Eigen::Matrix<double, kDerivativeCount, 1>;

/// Derivatives of several functions, a column each.
using DerivativeRows = Eigen::Matrix<double, kDerivativeCount, Eigen::Dynamic>;

/// One term of the product rule: (f g)_d = sum of binomial f_left g_right over the terms of d.
struct LeibnizTerm {
  int d, left, right;
  double binomial;
};

/// The terms of all derivatives, sorted by d.
constexpr auto leibniz_terms() {
  constexpr int kBinomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  std::array<LeibnizTerm, 35> terms{};
  int count = 0;
  for (int d = 0; d < kDerivativeCount; ++d) {
    for (int i = 0; i <= kOrderU[d]; ++i) {
      for (int j = 0; j <= kOrderV[d]; ++j) {
        const double binomial = kBinomial[kOrderU[d]][i] * kBinomial[kOrderV[d]][j];
        terms[count++] = {d, derivative_index(i, j), derivative_index(kOrderU[d] - i, kOrderV[d] - j), binomial};
      }
    }
  }
  return terms;
}

/// Derivatives of f times each function of `rows` (Leibniz).
template <class Rows>
typename Rows::PlainObject product(const Derivatives& f, const Eigen::MatrixBase<Rows>& rows) {
  constexpr auto kTerms = leibniz_terms();
  std::array<double, kTerms.size()> factors;
  for (std::size_t t = 0; t < kTerms.size(); ++t) factors[t] = kTerms[t].binomial * f[kTerms[t].left];
  typename Rows::PlainObject result = Rows::PlainObject::Zero(kDerivativeCount, rows.cols());
  for (Eigen::Index column = 0; column < rows.cols(); ++column) {
    const Derivatives g = rows.col(column);
    if ((g.array() == 0).all()) continue;  // most control points do not act here
    Derivatives sum = Derivatives::Zero();
#pragma GCC unroll 35
    for (std::size_t t = 0; t < kTerms.size(); ++t) sum[kTerms[t].d] += factors[t] * g[kTerms[t].right];
    result.col(column) = sum;
  }
  return result;
}

}  // namespace umbilic
