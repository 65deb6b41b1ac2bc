// SPDX-License-Identifier: MIT
/// \file
/// Densities do not depend on parameters, frame, or position in space, and scale as they should; umbilics are harmless.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "energy/density_values.h"
#include "energy/taylor.h"
#include "surface/derivatives.h"

namespace umbilic::test {
namespace {

void expect_equal(const DensityValues& a, const DensityValues& b, double tolerance) {
  for (int f = 0; f < kFunctionalCount; ++f) {
    EXPECT_NEAR(a[f], b[f], tolerance * std::max(1.0, std::abs(a[f]))) << kFunctionalNames[f];
  }
}

/// The surface with this jet as Taylor polynomials of (u, v), u = v = 0 at the jet.
TaylorPoint surface_of(Jet<double> jet, const Taylor& u, const Taylor& v) {
  TaylorPoint x;
  const auto derivatives = vectors(jet);
  constexpr double kFactorial[] = {1, 1, 2, 6};
  for (int d = 1; d < kDerivativeCount; ++d) {
    Taylor monomial = 1 / (kFactorial[kOrderU[d]] * kFactorial[kOrderV[d]]);
    for (int i = 0; i < kOrderU[d]; ++i) monomial = monomial * u;
    for (int i = 0; i < kOrderV[d]; ++i) monomial = monomial * v;
    x[0] += monomial * derivatives[d - 1]->x;
    x[1] += monomial * derivatives[d - 1]->y;
    x[2] += monomial * derivatives[d - 1]->z;
  }
  return x;
}

TEST(Densities, do_not_depend_on_a_linear_change_of_parameters) {
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const Jet<double> jet = random_jet(random);
    Taylor u, v;
    u.c[1] = 0.9;
    u.c[2] = -0.4;
    v.c[1] = 0.5;
    v.c[2] = 1.2;
    // Third-order densities of random jets are of the size 100 and more.
    expect_equal(densities(jet), densities(jet_of(surface_of(jet, u, v))), 1e-12);
    std::swap(u, v);  // turns the normal around
    expect_equal(densities(jet), densities(jet_of(surface_of(jet, u, v))), 1e-12);
  }
}

TEST(Densities, do_not_depend_on_a_curved_change_of_parameters) {
  Random random(2);
  for (int trial = 0; trial < 30; ++trial) {
    const Jet<double> jet = random_jet(random);
    const auto [u, v] = curved_parameters(0, 0);
    expect_equal(densities(jet), densities(jet_of(surface_of(jet, u, v))), 1e-11);
  }
}

TEST(Densities, do_not_change_under_rotations_and_scale_like_length_to_the_minus_2_4_and_6) {
  Random random(3);
  const double scale = 2.5;
  for (int trial = 0; trial < 30; ++trial) {
    Jet<double> jet = random_jet(random), moved = jet;
    for (Vec3<double>* v : vectors(moved)) *v = vec3(scale * some_rotation() * vector(*v));
    DensityValues expected = densities(jet);
    for (int f = 0; f < kFunctionalCount; ++f) expected[f] /= std::pow(scale, 2 + 2 * area_power(f));
    expect_equal(expected, densities(moved), 1e-12);
    EXPECT_NEAR(curvature(moved).area, scale * scale * curvature(jet).area, 1e-12 * curvature(moved).area);
  }
}

/// II and C in the frame turned by `angle`.
Curvature<double> turned(const Curvature<double>& k, double angle) {
  const double r[2][2] = {{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}};
  const double form[3] = {k.p, k.q, k.r};
  Curvature<double> result;
  double* const entries[3] = {&result.p, &result.q, &result.r};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      for (int n = 0; n < 3; ++n) {  // n indices are 2
        const int a = n == 2 ? 1 : 0, b = n >= 1 ? 1 : 0;
        *entries[n] += r[a][i] * r[b][j] * form[i + j];
      }
      for (int l = 0; l < 2; ++l) {
        for (int n = 0; n < 4; ++n) result.c[n] += r[n == 3][i] * r[n >= 2][j] * r[n >= 1][l] * k.c[i + j + l];
      }
    }
  }
  return result;
}

TEST(Densities, do_not_depend_on_the_frame_even_where_the_umbilic_regularization_acts) {
  Random random(4);
  for (const double gap : {1.0, 1e-3, 1e-6, 1e-8, 0.0}) {
    Curvature<double> k;
    k.p = 1.3;
    k.r = 1.3 - 1.2 * gap;
    k.q = 0.4 * gap;
    for (double& c : k.c) c = random();
    for (const double angle : {0.3, 1.1, 2.0}) {
      // Turning p, q, r loses 1e-16 / gap of the angle, or of eta where that is larger.
      const double tolerance = 1e-14 / std::max(gap, 1e-6) + 1e-14;
      expect_equal(densities(k), densities(turned(k, angle)), 10 * tolerance);
    }
  }
}

TEST(Densities, regularization_is_a_relative_change_of_1e_minus_12_where_principal_curvatures_differ) {
  // mvs of C = c0 alone in the principal frame is c0^2; cos 2 theta = 1 - O(eta^2).
  Curvature<double> k;
  k.p = 1;
  k.r = -1;
  k.c[0] = 2;
  EXPECT_NEAR(densities(k)[kMvs], 4, 4 * 1e-11);
  EXPECT_NEAR(densities(k)[kMvsCross], 4, 4 * 1e-11);
}

void expect_finite_with_gradients(const Jet<double>& jet) {
  const CurvatureFrame<double, true> frame(jet);
  for (int f = kMvs; f < kFunctionalCount; ++f) {
    Weights weights{};
    weights[f] = 1;
    Curvature<double> adjoint;
    EXPECT_TRUE(std::isfinite(third_order_density(weights.data(), frame.value(), 1.0, adjoint)));
    Jet<double> gradient = frame.pull_back(adjoint);
    for (const Vec3<double>* v : vectors(gradient)) EXPECT_TRUE(vector(*v).allFinite()) << kFunctionalNames[f];
  }
}

TEST(Densities, are_finite_with_finite_gradients_at_umbilics) {
  const auto [u, v] = curved_parameters(0.5, 0.3);
  const Jet<double> sphere = jet_of({cos(v) * cos(u), cos(v) * sin(u), sin(v)});
  expect_finite_with_gradients(sphere);
  for (int f = kMvs; f < kFunctionalCount; ++f) EXPECT_LT(densities(sphere)[f], 1e-20);

  Taylor s, t;
  s.c[1] = t.c[2] = 1;
  expect_finite_with_gradients(jet_of({s, t, Taylor()}));                                 // plane
  expect_finite_with_gradients(jet_of({s, t, s * s * s - 3 * s * t * t}));                // monkey saddle
  expect_finite_with_gradients(jet_of({s, t, (s * s + t * t) * 0.5 + s * s * s * 0.2}));  // umbilic with C != 0
}

}  // namespace
}  // namespace umbilic::test
