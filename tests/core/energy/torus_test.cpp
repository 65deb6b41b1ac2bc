// SPDX-License-Identifier: MIT
/// \file
/// The torus of revolution: its closed forms against quadrature of the densities and against meshed tori, and the ratio
/// of least energy against the paper's equation for it.
#include "energy/torus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "energy/density_values.h"
#include "energy/surface_energy.h"
#include "energy/taylor.h"

namespace umbilic::test {
namespace {

using std::numbers::pi;
constexpr double kClifford = std::numbers::sqrt2 / 2;

/// Bending and MVS_cross with the weights of the paper's eq. 9.
Weights blend(double w1, double w2) {
  Weights weights{};
  weights[kBending] = w1;
  weights[kMvsCross] = w2;
  return weights;
}

double energy(const Weights& weights, double ratio) {
  const auto energies = torus_energies(ratio);
  double sum = 0;
  for (int f = 0; f < kFunctionalCount; ++f) sum += weights[f] * energies[f];
  return sum;
}

TEST(Torus, energies_are_the_integrals_of_the_densities) {
  for (const double a : {0.05, 0.2413, 0.5, kClifford, 0.9}) {
    // The trapezoidal rule on a period converges exponentially, the more slowly the closer a is to 1.
    constexpr int kNodes = 400;
    DensityValues sums{};
    double area = 0;
    for (int i = 0; i < kNodes; ++i) {
      const double latitude = 2 * pi * i / kNodes;
      const auto [u, v] = curved_parameters(0.3, latitude);
      const Taylor radius = 1 + a * cos(v);
      const Jet<double> jet = jet_of({radius * cos(u), radius * sin(u), a * sin(v)});
      const double measure = (1 + a * std::cos(latitude)) * a * 4 * pi * pi / kNodes;
      const DensityValues values = densities(jet);
      for (int f = 0; f < kFunctionalCount; ++f) sums[f] += measure * values[f];
      area += measure;
    }
    const auto energies = torus_energies(a);
    const double scale = energies[kMvsCross];
    EXPECT_NEAR(sums[kBending], energies[kBending], 1e-10 * energies[kBending]);
    EXPECT_NEAR(sums[kWillmore], energies[kWillmore], 1e-10 * energies[kWillmore]);
    for (int f = kMvs; f < kFunctionalCount; ++f) {
      EXPECT_NEAR(sums[f] * std::pow(area, area_power(f)), energies[f], 1e-10 * std::max(scale, energies[f])) << f << a;
    }
  }
}

TEST(Torus, energies_are_the_limits_of_meshed_tori_as_the_square_of_the_mesh_width) {
  for (const double a : {0.3, 0.6}) {
    const auto exact = torus_energies(a);
    std::array<double, kFunctionalCount> before{};
    for (const int segments : {32, 64, 128}) {
      const Cage cage = *generate_cage("torus", {.ratio = a, .major_segments = segments, .minor_segments = segments});
      const PatchLayout layout(PolygonMesh(cage), CapKind::kNone);
      const auto sums = surface_integrals(JetEvaluator(layout, {6, 6, 0}), cage.vertices).functionals;
      for (int f = 0; f < kFunctionalCount; ++f) {
        const double error = std::abs(sums[f] - exact[f]);
        if (segments > 32) {
          EXPECT_LT(error, 0.3 * before[f]) << kFunctionalNames[f] << " on " << segments;
        }
        before[f] = error;
      }
    }
  }
}

TEST(Torus, of_least_bending_is_the_clifford_torus) {
  for (const int functional : {kBending, kWillmore}) {
    Weights weights{};
    weights[functional] = 1;
    const TorusMinimizer minimizer = torus_minimizer(weights);
    EXPECT_NEAR(minimizer.ratio, kClifford, 1e-15);
    EXPECT_NEAR(minimizer.energy, (functional == kBending ? 8 : 2) * pi * pi, 1e-12);
    EXPECT_TRUE(minimizer.attained);
  }
}

TEST(Torus, of_third_order_functionals_has_an_infimum_that_none_attains_but_mvs) {
  const double thin = 8 * std::pow(pi, 4);
  for (const auto& [functional, factor] : {std::pair{kMvsCross, 1.0},
                                           {kMehlumTarrou, 9.0 / 16},
                                           {kSecondFormVariation, 3.0},
                                           {kMeanCurvatureVariation, 1.0},
                                           {kCurvednessVariation, 0.0}}) {
    Weights weights{};
    weights[functional] = 2;
    const TorusMinimizer minimizer = torus_minimizer(weights);
    EXPECT_FALSE(minimizer.attained);
    EXPECT_EQ(minimizer.ratio, 0);
    EXPECT_NEAR(minimizer.energy, 2 * factor * thin, 1e-12 * thin);
    EXPECT_GT(energy(weights, 1e-3), minimizer.energy);
  }
  Weights weights{};
  weights[kMvs] = 1;
  const TorusMinimizer minimizer = torus_minimizer(weights);
  EXPECT_TRUE(minimizer.attained);
  EXPECT_EQ(minimizer.energy, 0);
  EXPECT_TRUE(std::isnan(minimizer.ratio)) << "all tori have the same";
}

TEST(Torus, of_a_blend_solves_the_equation_of_its_ratio) {
  for (double c = 1e-12; c < 1e13; c *= 10) {
    const double a = torus_minimizer(blend(1, c)).ratio;
    // As a product, because 1 - 2 a^2 cancels near the Clifford torus.
    const double left = 6 * pi * pi * a * a * a * c, right = (1 - a * a) * (1 - 2 * a * a);
    EXPECT_NEAR(left, right, 1e-10 * left + 1e-15) << c;
  }
}

TEST(Torus, of_a_blend_has_the_least_energy) {
  for (const auto& [w1, w2] : {std::pair{1.0, 1.0}, {0.95, 0.05}, {1.0, 1e-4}, {1e-4, 1.0}}) {
    for (const double w3 : {0.0, 1e-3, 1.0}) {
      Weights weights = blend(w1, w2);
      weights[kCurvednessVariation] = w3;
      const TorusMinimizer minimizer = torus_minimizer(weights);
      EXPECT_NEAR(minimizer.energy, energy(weights, minimizer.ratio), 1e-14 * minimizer.energy);
      // A change of the ratio by 1e-4 changes the energy by about 1e-8 of it.
      for (const double other : {0.9999, 1.0001}) {
        EXPECT_GT(energy(weights, other * minimizer.ratio), minimizer.energy) << w1 << " " << w2 << " " << w3;
      }
    }
  }
}

TEST(Torus, of_the_papers_blends_has_the_ratios_0_2413_and_0_4966) {
  EXPECT_NEAR(torus_minimizer(blend(1, 1)).ratio, 0.2413, 5e-5);
  EXPECT_NEAR(torus_minimizer(blend(0.95, 0.05)).ratio, 0.4966, 5e-5);
}

TEST(Torus, of_a_blend_depends_on_the_ratio_of_the_weights_only) {
  const double ratio = torus_minimizer(blend(1, 1)).ratio;
  for (const double scale : {1e-300, 1e-3, 1e300}) EXPECT_EQ(torus_minimizer(blend(scale, scale)).ratio, ratio);
  // Of each functional as much as of bending or MVS_cross.
  Weights others{};
  others[kWillmore] = 4;
  others[kMvs] = 7;
  others[kMehlumTarrou] = 8.0 / 9;
  others[kSecondFormVariation] = 1.0 / 12;
  others[kMeanCurvatureVariation] = 1.0 / 4;
  EXPECT_NEAR(torus_minimizer(others).ratio, ratio, 1e-15);
}

}  // namespace
}  // namespace umbilic::test
