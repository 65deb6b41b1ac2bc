// SPDX-License-Identifier: MIT
/// \file
/// Densities against difference quotients of the principal curvatures and of normal curvatures on a generic polynomial
/// surface.
#include <gtest/gtest.h>

#include <numbers>

#include "energy/density_values.h"
#include "energy/graph_surface.h"

namespace umbilic::test {
namespace {

constexpr std::pair<double, double> kPlaces[] = {{0.1, 0.2},   {-0.4, 0.3}, {0.5, -0.6},
                                                 {-0.3, -0.7}, {0.8, 0.45}, {0, 0}};

/// Truncation and round-off of the quotients are far smaller; the regularization of umbilics changes 1e-12.
constexpr double kTolerance = 1e-9;

DensityValues densities_at(double x, double y) {
  const auto [u, v] = curved_parameters(x, y);
  return densities(jet_of(Graph::point(u, v)));
}

TEST(GraphSurface, derivatives_are_those_of_its_height) {
  for (const auto& [x, y] : kPlaces) {
    Taylor u = x, v = y;
    u.c[1] = v.c[2] = 1;
    const Taylor height = Graph::height(u, v);
    const Graph::Height d = Graph::derivatives(x, y);
    EXPECT_NEAR(height.derivative(1, 0), static_cast<double>(d.x), 1e-14);
    EXPECT_NEAR(height.derivative(0, 1), static_cast<double>(d.y), 1e-14);
    EXPECT_NEAR(height.derivative(2, 0), static_cast<double>(d.xx), 1e-14);
    EXPECT_NEAR(height.derivative(1, 1), static_cast<double>(d.xy), 1e-14);
    EXPECT_NEAR(height.derivative(0, 2), static_cast<double>(d.yy), 1e-14);
  }
}

TEST(Densities, equal_difference_quotients_of_principal_curvatures_along_principal_directions) {
  for (const auto& [x, y] : kPlaces) {
    const std::array<Real, 2> kappa = principal_curvatures(x, y);
    Real slopes[2][2];  // [curvature][direction]
    for (int direction = 0; direction < 2; ++direction) {
      const auto [a, b] = principal_direction(x, y, kappa[direction]);
      for (int i = 0; i < 2; ++i) {
        slopes[i][direction] = slope(
            [&, x0 = x, y0 = y, a0 = a, b0 = b](Real h) { return principal_curvatures(x0 + h * a0, y0 + h * b0)[i]; });
      }
    }
    const auto square = [](Real s) { return static_cast<double>(s * s); };
    const double mvs = square(slopes[0][0]) + square(slopes[1][1]);
    const double cross = mvs + square(slopes[0][1]) + square(slopes[1][0]);
    const double variation = mvs + 3 * (square(slopes[0][1]) + square(slopes[1][0]));
    const DensityValues values = densities_at(x, y);
    EXPECT_NEAR(values[kBending], square(kappa[0]) + square(kappa[1]), 1e-12 * values[kBending]);
    EXPECT_NEAR(values[kWillmore], square((kappa[0] + kappa[1]) / 2), 1e-12 * values[kBending]);
    EXPECT_NEAR(values[kMvs], mvs, kTolerance * cross) << "at " << x << ", " << y;
    EXPECT_NEAR(values[kMvsCross], cross, kTolerance * cross);
    EXPECT_NEAR(values[kSecondFormVariation], variation, kTolerance * variation);
    double mean = 0, curvedness = 0;
    for (int direction = 0; direction < 2; ++direction) {
      mean += square(slopes[0][direction] + slopes[1][direction]);
      curvedness += square(kappa[0] * slopes[0][direction] + kappa[1] * slopes[1][direction]);
    }
    EXPECT_NEAR(values[kMeanCurvatureVariation], mean, kTolerance * cross);
    EXPECT_NEAR(values[kCurvednessVariation], curvedness, kTolerance * values[kBending] * cross);
  }
}

/// Derivative by arc length of the normal curvature along the geodesic through (x, y) at `angle`.
Real normal_curvature_slope(double x, double y, Real angle) {
  const auto [e, f, g, l, m, n] = forms(x, y);
  // Orthonormal frame from d/dx.
  const Real alpha = 1 / std::sqrt(e), gamma = std::sqrt(e / (e * g - f * f)), beta = -f / e * gamma;
  const Real a = std::cos(angle) * alpha + std::sin(angle) * beta, b = std::sin(angle) * gamma;
  // On a graph Christoffel symbols are h_k h_ij / (1 + |grad h|^2); a curve that is geodesic at one point will do.
  const Graph::Height h = Graph::derivatives(x, y);
  const Real bend = (h.xx * a * a + 2 * h.xy * a * b + h.yy * b * b) / (1 + h.x * h.x + h.y * h.y);
  return slope([&](Real s) {
    const Real u = x + s * a - s * s / 2 * h.x * bend, v = y + s * b - s * s / 2 * h.y * bend;
    const Real du = a - s * h.x * bend, dv = b - s * h.y * bend;
    const FundamentalForms there = forms(u, v);
    return (there.l * du * du + 2 * there.m * du * dv + there.n * dv * dv) /
           (there.e * du * du + 2 * there.f * du * dv + there.g * dv * dv);
  });
}

TEST(Densities, mehlum_tarrou_is_the_mean_square_slope_of_normal_curvature_over_all_directions) {
  for (const auto& [x, y] : kPlaces) {
    constexpr int kDirections = 8;  // the square is a trigonometric polynomial of degree 6
    Real mean = 0;
    for (int i = 0; i < kDirections; ++i) {
      const Real s = normal_curvature_slope(x, y, 2 * std::numbers::pi_v<Real> * i / kDirections);
      mean += s * s / kDirections;
    }
    const double expected = static_cast<double>(mean);
    EXPECT_NEAR(densities_at(x, y)[kMehlumTarrou], expected, kTolerance * expected);
  }
}

TEST(Densities, second_form_variation_is_the_norm_of_the_cubic_form_of_those_slopes) {
  // c(t) = Re(z1 e^(-it) + z3 e^(-3it)) has the tensor norm 4/3 |z1|^2 + 4 |z3|^2.
  for (const auto& [x, y] : kPlaces) {
    constexpr int kDirections = 8;
    Real re1 = 0, im1 = 0, re3 = 0, im3 = 0;
    for (int i = 0; i < kDirections; ++i) {
      const Real t = 2 * std::numbers::pi_v<Real> * i / kDirections,
                 s = normal_curvature_slope(x, y, t) * 2 / kDirections;
      re1 += s * std::cos(t);
      im1 += s * std::sin(t);
      re3 += s * std::cos(3 * t);
      im3 += s * std::sin(3 * t);
    }
    const double expected = static_cast<double>(4 * (re1 * re1 + im1 * im1) / 3 + 4 * (re3 * re3 + im3 * im3));
    EXPECT_NEAR(densities_at(x, y)[kSecondFormVariation], expected, kTolerance * expected);
  }
}

}  // namespace
}  // namespace umbilic::test
