// SPDX-License-Identifier: MIT
/// \file
/// The density of the parametrization against closed forms and invariances, and its integral's derivatives against
/// differences.
#include <gtest/gtest.h>

#include <cmath>

#include "energy/density_values.h"
#include "energy/dual.h"
#include "energy/surface_energy.h"
#include "reference/reference_cages.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

double density(const Jet<double>& jet) {
  const CurvatureFrame<double, false, true> frame(jet);
  Curvature<double> unused;
  return parametrization_density(frame.value(), 0.0, unused);
}

/// The jet of X(A (u, v)).
Jet<double> composed(const Jet<double>& jet, const Eigen::Matrix2d& a) {
  const auto sum = [](const Vec3<double>& x, double s, const Vec3<double>& y, double t) { return x * s + y * t; };
  Jet<double> result{};
  for (int j = 0; j < 2; ++j) result.first[j] = sum(jet.first[0], a(0, j), jet.first[1], a(1, j));
  for (int ij = 0; ij < 3; ++ij) {
    const int i = ij == 2 ? 1 : 0, j = ij == 0 ? 0 : 1;
    result.second[ij] = sum(jet.second[0], a(0, i) * a(0, j), jet.second[1], a(0, i) * a(1, j) + a(1, i) * a(0, j));
    result.second[ij] += jet.second[2] * (a(1, i) * a(1, j));
  }
  return result;
}

TEST(ParametrizationDensity, of_polar_coordinates_is_3_over_the_square_of_the_radius) {
  for (const double r : {0.3, 1.0, 7.0}) {
    for (const double angle : {0.0, 1.1}) {
      const double c = std::cos(angle), s = std::sin(angle);
      const Jet<double> jet{{{c, s, 0}, {-r * s, r * c, 0}}, {{0, 0, 0}, {-s, c, 0}, {-r * c, -r * s, 0}}, {}};
      EXPECT_NEAR(density(jet) * r * r, 3, 1e-14);
    }
  }
}

TEST(ParametrizationDensity, is_0_where_parameters_are_lengths_on_a_cylinder) {
  const double u = 0.4;
  const Jet<double> jet{{{-std::sin(u), std::cos(u), 0}, {0, 0, 1}}, {{-std::cos(u), -std::sin(u), 0}, {}, {}}, {}};
  EXPECT_NEAR(density(jet), 0, 1e-30);
}

TEST(ParametrizationDensity, does_not_change_with_affine_parameters_and_falls_with_the_square_of_the_size) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Jet<double> jet = random_jet(random);
    const double value = density(jet);
    Eigen::Matrix2d a = Eigen::Matrix2d::Identity() + 0.6 * random.matrix<Eigen::Matrix2d>(2, 2);
    if (std::abs(a.determinant()) < 0.1) continue;
    EXPECT_NEAR(density(composed(jet, a)) / value, 1, 1e-9);
    Jet<double> larger = jet;
    for (Vec3<double>* v : vectors(larger)) *v = *v * 3.0;
    EXPECT_NEAR(density(larger) / value, 1.0 / 9, 1e-13);
  }
}

TEST(ParametrizationDensity, has_the_gradient_by_the_symbols_that_dual_numbers_have) {
  Random random(4);
  Curvature<double> k, adjoint;
  for (auto& row : k.christoffel) {
    for (double& symbol : row) symbol = random();
  }
  parametrization_density(k, 1.7, adjoint);
  for (int m = 0; m < 2; ++m) {
    for (int i = 0; i < 3; ++i) {
      Curvature<Dual> dual, unused;
      for (int n = 0; n < 2; ++n) {
        for (int j = 0; j < 3; ++j) dual.christoffel[n][j] = Dual(k.christoffel[n][j], n == m && j == i ? 1 : 0);
      }
      EXPECT_NEAR(adjoint.christoffel[m][i], 1.7 * parametrization_density(dual, Dual(1), unused).dx, 1e-14);
    }
  }
}

TEST(SurfaceEnergy, with_a_weighted_parametrization_has_the_energy_without_it_and_the_gradient_of_the_sum) {
  const Refined mesh = refined(reference_cage("g2"), 2);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, {3, 4, 2});
    for (const Weights& weights :
         {Weights{1, 0, 0, 0, 0, 0}, Weights{0, 0, 0, 1, 0, 0}, Weights{0.3, 0, 0, 1e-3, 0, 0}}) {
      const SurfaceEnergy energy(jets, weights);
      const double weight = 2.5;
      Points gradient, alone;
      const EnergyValue value = energy.evaluate(mesh.control, &gradient, weight);
      EXPECT_NEAR(value.energy / energy.evaluate(mesh.control, &alone).energy, 1, 1e-13);
      EXPECT_NEAR(value.parametrization / weight / surface_integrals(jets, mesh.control).parametrization, 1, 1e-12);
      gradient -= alone;
      Random random(12);
      const Points direction = random.points(mesh.control.rows());
      const auto at = [&](double t) {
        return energy.evaluate(mesh.control + t * direction, nullptr, weight).parametrization;
      };
      const double h = 1e-4, slope = gradient.cwiseProduct(direction).sum();
      EXPECT_NEAR((8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h) / slope, 1, 1e-6)
          << "cap " << static_cast<int>(cap);
    }
  }
}

}  // namespace
}  // namespace umbilic::test
