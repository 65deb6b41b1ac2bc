// SPDX-License-Identifier: MIT
/// \file
/// Densities of tori, spheres, cylinders, cones and ellipsoids in closed form, in curved parameters.
#include <gtest/gtest.h>

#include <cmath>

#include "energy/density_values.h"
#include "energy/taylor.h"

namespace umbilic::test {
namespace {

TaylorPoint torus(double major, double minor, const Taylor& u, const Taylor& v) {
  const Taylor radius = major + minor * cos(v);
  return {radius * cos(u), radius * sin(u), minor * sin(v)};
}

/// Expects principal curvatures (up to order and a common sign) and the derivatives (dk1/de1, dk1/de2, dk2/de1,
/// dk2/de2).
void expect_curvature(const Jet<double>& jet, double k1, double k2, const std::array<double, 4>& slopes) {
  const Curvature<double> k = curvature(jet);
  const DensityValues values = densities(k);
  const auto [c111, c112, c122, c222] = slopes;
  // Round-off of derivatives of size 10 to 100 through quotients; the regularization is 1e-12.
  const double second = 1e-12 * (1 + k1 * k1 + k2 * k2);
  EXPECT_NEAR(k.p * k.r - k.q * k.q, k1 * k2, second);
  EXPECT_NEAR(values[kBending], k1 * k1 + k2 * k2, second);
  EXPECT_NEAR(values[kWillmore], (k1 + k2) * (k1 + k2) / 4, second);
  const double sum = c111 * c111 + 3 * c112 * c112 + 3 * c122 * c122 + c222 * c222, third = 1e-10 * (1 + sum);
  EXPECT_NEAR(values[kSecondFormVariation], sum, third);
  EXPECT_NEAR(values[kMvs], c111 * c111 + c222 * c222, third);
  EXPECT_NEAR(values[kMvsCross], c111 * c111 + c112 * c112 + c122 * c122 + c222 * c222, third);
  EXPECT_NEAR(
      values[kMehlumTarrou],
      (5 * c111 * c111 + 9 * c112 * c112 + 9 * c122 * c122 + 5 * c222 * c222 + 6 * c111 * c122 + 6 * c112 * c222) / 16,
      third);
  const auto length2 = [](double x, double y) { return x * x + y * y; };
  EXPECT_NEAR(values[kMeanCurvatureVariation], length2(c111 + c122, c112 + c222), third);
  EXPECT_NEAR(values[kCurvednessVariation], length2(k1 * c111 + k2 * c122, k1 * c112 + k2 * c222),
              third * (1 + k1 * k1 + k2 * k2));
}

TEST(Densities, of_a_torus_vary_only_by_the_derivative_of_one_curvature_along_the_other_line) {
  const double major = 1.3, minor = 0.6;
  for (double v = -3; v < 3; v += 0.7) {
    const auto [s, t] = curved_parameters(0.4 + v, v);
    // kappa = 1/r along the circles of the tube, cos v / (R + r cos v) around the axis; the latter changes along the
    // former, by arc length r v.
    const double w = major + minor * std::cos(v);
    expect_curvature(jet_of(torus(major, minor, s, t)), 1 / minor, std::cos(v) / w,
                     {0, 0, -major * std::sin(v) / (w * w * minor), 0});
  }
}

TEST(Densities, of_third_order_vanish_on_spheres_and_cylinders) {
  const auto [u, v] = curved_parameters(0.7, 0.4);
  const double r = 1.7;
  const Jet<double> sphere = jet_of({r * cos(v) * cos(u), r * cos(v) * sin(u), r * sin(v)});
  expect_curvature(sphere, 1 / r, 1 / r, {0, 0, 0, 0});
  const Jet<double> cylinder = jet_of({r * cos(u), r * sin(u), v + u * 0.5});
  expect_curvature(cylinder, 1 / r, 0, {0, 0, 0, 0});
}

TEST(Densities, of_a_cone_change_along_its_rulings) {
  const double half_angle = 0.6, s = std::sin(half_angle), c = std::cos(half_angle);
  for (const double distance : {0.5, 1.0, 3.0}) {
    const auto [u, rho] = curved_parameters(1.2, distance);
    // kappa = cot(half angle) / distance around the axis, 0 along the rulings.
    const double cot = c / s;
    expect_curvature(jet_of({rho * s * cos(u), rho * s * sin(u), rho * c}), 0, cot / distance,
                     {0, 0, -cot / (distance * distance), 0});
  }
}

TEST(Densities, of_an_ellipsoid_follow_from_its_support_function) {
  const double a = 1, b = 1.4, c = 2.1;
  for (const auto& [s, t] : {std::pair{0.3, 0.2}, {1.1, -0.6}, {-2.0, 0.9}, {2.4, -1.2}}) {
    const auto [u, v] = curved_parameters(s, t);
    const TaylorPoint x{a * cos(v) * cos(u), b * cos(v) * sin(u), c * sin(v)};
    // With h the distance of the tangent plane from the centre: K = h^4 / (abc)^2, H = h^3 (a^2 + b^2 + c^2 - |x|^2) /
    // (2 (abc)^2), here as Taylor polynomials, so that gradients come with them.
    const double volume = a * a * b * b * c * c;
    const Taylor h =
        pow(x[0] * x[0] * std::pow(a, -4) + x[1] * x[1] * std::pow(b, -4) + x[2] * x[2] * std::pow(c, -4), -0.5);
    const Taylor gauss = pow(h, 4) * (1 / volume);
    const Taylor mean = pow(h, 3) * (a * a + b * b + c * c - x[0] * x[0] - x[1] * x[1] - x[2] * x[2]) * (0.5 / volume);
    const Taylor deviation = sqrt(mean * mean - gauss);

    const Jet<double> jet = jet_of(x);
    const Vec3<double>&xu = jet.first[0], &xv = jet.first[1];
    const double e = dot(xu, xu), f = dot(xu, xv), g = dot(xv, xv);
    const auto squared_gradient = [&](const Taylor& k) {
      const double ku = k.derivative(1, 0), kv = k.derivative(0, 1);
      return (g * ku * ku - 2 * f * ku * kv + e * kv * kv) / (e * g - f * f);
    };
    const DensityValues values = densities(jet);
    const double m = mean.c[0], d = deviation.c[0];
    const double cross = squared_gradient(mean + deviation) + squared_gradient(mean - deviation);
    EXPECT_NEAR(values[kWillmore], m * m, 1e-12 * m * m);
    EXPECT_NEAR(values[kBending], 2 * (m * m + d * d), 1e-12 * m * m);
    EXPECT_NEAR(curvature(jet).p * curvature(jet).r - std::pow(curvature(jet).q, 2), gauss.c[0], 1e-12 * m * m);
    EXPECT_NEAR(values[kMvsCross], cross, 1e-10 * cross);
    const double mean_variation = 4 * squared_gradient(mean), curvedness = squared_gradient(2 * mean * mean - gauss);
    EXPECT_NEAR(values[kMeanCurvatureVariation], mean_variation, 1e-10 * mean_variation);
    EXPECT_NEAR(values[kCurvednessVariation], curvedness, 1e-10 * curvedness);
  }
}

}  // namespace
}  // namespace umbilic::test
