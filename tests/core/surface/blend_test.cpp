// SPDX-License-Identifier: MIT
/// \file
/// Blends against the paper's formula, closed forms and difference quotients in extended precision.
#include "surface/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbilic::test {
namespace {

using Function = long double (*)(long double);

/// Joshi & Sequin eq. 8, as printed.
long double eq8(long double t) {
  const auto h = [](long double x) { return std::exp(2 * std::exp(-1 / x) / (x - 1)); };
  return h(t) / (h(t) + h(1 - t));
}

/// The C^3 smoothstep is the normalized integral of t^3 (1 - t)^3, written out.
long double smoothstep(long double t) { return 1 - t * t * t * t * (35 - t * (84 - t * (70 - 20 * t))); }

/// Central differences of order 1 to 3, with the error h^2 removed twice by Richardson.
long double difference(Function f, long double t, int order, long double h) {
  const auto plain = [&](long double e) -> long double {
    if (order == 1) return (f(t + e) - f(t - e)) / (2 * e);
    if (order == 2) return (f(t + e) - 2 * f(t) + f(t - e)) / (e * e);
    return (f(t + 2 * e) - 2 * f(t + e) + 2 * f(t - e) - f(t - 2 * e)) / (2 * e * e * e);
  };
  const long double a = plain(h), b = plain(h / 2), c = plain(h / 4);
  const long double ab = (4 * b - a) / 3, bc = (4 * c - b) / 3;
  return (16 * bc - ab) / 15;
}

void expect_derivatives(Derivatives1 (*blend)(double), Function reference, double t, long double step) {
  const Derivatives1 actual = blend(t);
  // Terms of size 70 cancel in the smoothstep.
  EXPECT_NEAR(actual[0], static_cast<double>(reference(t)), 1e-14) << "t = " << t;
  for (int order = 1; order < 4; ++order) {
    // Truncation h^6 f^(order + 6), and round-off 1e-19 / h^3 in the third derivative.
    EXPECT_NEAR(actual[order], static_cast<double>(difference(reference, t, order, step)), 2e-8)
        << "t = " << t << " " << order;
  }
}

TEST(PaperBlend, equals_eq_8_and_its_difference_quotients) {
  for (double t = 0.1; t < 0.95; t += 0.05) expect_derivatives(paper_blend, eq8, t, 1e-3L);
}

TEST(PaperBlend, is_1_at_the_vertex_one_half_in_the_middle_0_at_the_rim) {
  EXPECT_EQ(paper_blend(0), Derivatives1(1, 0, 0, 0));
  EXPECT_EQ(paper_blend(1), Derivatives1(0, 0, 0, 0));
  EXPECT_DOUBLE_EQ(paper_blend(0.5)[0], 0.5);
  // In the middle the blend is 1/2 - tanh(x / 2) / 2 with x' = -2 (log h)'(1/2) and (log h)' = 2 exp(-1/t) (1/(t^2 (t -
  // 1)) - 1/(t - 1)^2): slope -x'/4 = -(2 * 2 * 12 exp(-2)) / 4.
  EXPECT_NEAR(paper_blend(0.5)[1], -12 * std::exp(-2.0), 1e-14);
}

TEST(PaperBlend, of_t_and_of_1_minus_t_sum_to_1) {
  for (const double t : {0.01, 0.03, 0.08, 0.2, 0.37}) {
    const Derivatives1 a = paper_blend(t), b = paper_blend(1 - t);
    EXPECT_NEAR(a[0] + b[0], 1, 1e-15);
    EXPECT_NEAR(a[1], b[1], 1e-13);
    EXPECT_NEAR(a[2], -b[2], 1e-11);
    EXPECT_NEAR(a[3], b[3], 1e-10);
  }
}

TEST(PaperBlend, falls_from_1_to_0_and_is_finite_and_flat_close_to_both_ends) {
  double last = 1;
  for (double t = 1e-4; t < 1; t += 1e-4) {
    const Derivatives1 b = paper_blend(t);
    EXPECT_TRUE(b.allFinite()) << t;
    EXPECT_LE(b[0], last);
    last = b[0];
  }
  for (const double t : {1e-300, 1e-17, 1e-8, 1e-3, 0.01}) {
    EXPECT_LT((paper_blend(t) - Derivatives1(1, 0, 0, 0)).norm(), 1e-20) << t;
    EXPECT_LT(paper_blend(1 - std::max(t, 1e-16)).norm(), 1e-20) << t;
  }
}

TEST(SmoothstepBlend, equals_its_polynomial_and_difference_quotients) {
  for (double t = 0.05; t < 1; t += 0.05) expect_derivatives(smoothstep_blend, smoothstep, t, 1e-2L);
}

TEST(SmoothstepBlend, has_the_derivative_minus_140_t3_s3_and_three_vanishing_derivatives_at_both_ends) {
  for (const double t : {0.1, 0.5, 0.8}) EXPECT_NEAR(smoothstep_blend(t)[1], -140 * std::pow(t * (1 - t), 3), 1e-14);
  EXPECT_LT((smoothstep_blend(1e-6) - Derivatives1(1, 0, 0, 0)).norm(), 1e-2);  // the third is 840 t
  EXPECT_LT(smoothstep_blend(1 - 1e-6).norm(), 1e-2);
  EXPECT_EQ(smoothstep_blend(0), Derivatives1(1, 0, 0, 0));
  EXPECT_EQ(smoothstep_blend(1), Derivatives1(0, 0, 0, 0));
}

TEST(TensorBlend, is_the_product_with_scaled_derivatives) {
  const double u = 0.7, v = 1.4;
  const Derivatives1 f = smoothstep_blend(u / 2), g = smoothstep_blend(v / 2);
  const Derivatives b = tensor_blend(smoothstep_blend, u, v, 2);
  for (int d = 0; d < kDerivativeCount; ++d) {
    const double expected = f[kOrderU[d]] * g[kOrderV[d]] / std::pow(2, kOrderU[d] + kOrderV[d]);
    EXPECT_NEAR(b[d], expected, 1e-15) << "derivative " << d;
  }
}

}  // namespace
}  // namespace umbilic::test
