// SPDX-License-Identifier: MIT
/// \file
/// Truncated power series against derivatives known in closed form.
#include "opinion/taylor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbilic::opinion {
namespace {

TEST(Taylor, of_products_and_functions_have_the_derivatives_of_exp_of_a_polynomial) {
  // f = exp(s^2 t) at (1, 2): f_s = 2 s t f, f_t = s^2 f, f_ssst = f (8 s^3 t^3 + 12 s t^2)_t + ... by hand below.
  const Taylor s = Taylor::along_s(1, 1), t = Taylor::along_t(2, 1), f = exp(s * s * t);
  const double e = std::exp(2.0);
  EXPECT_NEAR(f.derivative(0, 0), e, 1e-13);
  EXPECT_NEAR(f.derivative(1, 0), 4 * e, 1e-12);                  // 2 s t
  EXPECT_NEAR(f.derivative(0, 1), e, 1e-13);                      // s^2
  EXPECT_NEAR(f.derivative(2, 0), (4 + 16) * e, 1e-11);           // 2 t + (2 s t)^2
  EXPECT_NEAR(f.derivative(1, 1), (2 + 4) * e, 1e-12);            // 2 s + 2 s t s^2
  EXPECT_NEAR(f.derivative(3, 0), (48 + 64) * e, 1e-11);          // 12 s t^2 + (2 s t)^3
  EXPECT_NEAR(f.derivative(2, 1), (2 + 16 + 4 + 16) * e, 1e-11);  // 2 + 8 s^2 t + 2 t s^2 + 4 s^4 t^2
  EXPECT_NEAR(f.derivative(0, 3), e, 1e-12);                      // s^6
}

TEST(Taylor, lose_one_order_when_differentiated) {
  const Taylor s = Taylor::along_s(0.3, 1), t = Taylor::along_t(0.7, 1), f = s * s * s * t + t * t;
  EXPECT_NEAR(f.by_s().derivative(1, 1), 6 * 0.3, 1e-14);
  EXPECT_NEAR(f.by_t().derivative(2, 0), 6 * 0.3, 1e-14);
  EXPECT_NEAR(f.by_t().derivative(0, 1), 2, 1e-14);
}

TEST(Taylor, invert_powers_and_trigonometric_functions) {
  const Taylor x = Taylor::along_s(0.4, 1.5) + Taylor::along_t(0.2, -0.5);
  const Taylor one = sin(x) * sin(x) + cos(x) * cos(x), same = sqrt(x) * sqrt(x), unit = x * pow(x, -1);
  for (int i = 0; i < Taylor::kCount; ++i) {
    EXPECT_NEAR(one.c[i], i == 0, 1e-14);
    EXPECT_NEAR(same.c[i], x.c[i], 1e-14);
    EXPECT_NEAR(unit.c[i], i == 0, 1e-13);
  }
}

}  // namespace
}  // namespace umbilic::opinion
