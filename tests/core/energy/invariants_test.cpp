// SPDX-License-Identifier: MIT
/// \file
/// The quadratic third-order invariants: as contractions of tensors, the identities that make the other densities of
/// them, and what is odd among them.
#include "energy/invariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "energy/density_values.h"
#include "energy/odd_densities.h"
#include "energy/surface_energy.h"
#include "energy/taylor.h"
#include "reference/reference_cages.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

using std::numbers::pi;

using InvariantDensities = std::array<double, kInvariantCount>;

InvariantDensities odd_densities(const Curvature<double>& k) {
  InvariantDensities values;
  values[kGradientForm] = gradient_form_density(k);
  values[kVariationForm] = variation_form_density(k);
  values[kTripleForm] = triple_form_density(k);
  return values;
}

/// II, C and the contractions T and v, by their indices.
struct Tensors {
  double h[2][2], c[2][2][2], t[2] = {}, v[2] = {};

  explicit Tensors(const Curvature<double>& k) : h{{k.p, k.q}, {k.q, k.r}} {
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        for (int l = 0; l < 2; ++l) c[i][j][l] = k.c[i + j + l];
      }
    }
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        t[i] += c[i][j][j];
        for (int l = 0; l < 2; ++l) v[l] += h[i][j] * c[i][j][l];
      }
    }
  }
};

/// A sum over six indices, most of which the term needs equal.
template <class Term>
double sum_over_indices(const Term& term) {
  double sum = 0;
  for (int n = 0; n < 64; ++n) sum += term(n & 1, n >> 1 & 1, n >> 2 & 1, n >> 3 & 1, n >> 4 & 1, n >> 5 & 1);
  return sum;
}

TEST(Invariants, are_the_contractions_of_their_tensors) {
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const Curvature<double> k = curvature(random_jet(random));
    const Tensors s(k);
    const DensityValues even = densities(k);
    const InvariantDensities odd = odd_densities(k);
    const double unit = even[kSecondFormVariation], bending = even[kBending], root = std::sqrt(bending);
    const auto c2 = [&](int i, int j, int l, int a, int b, int d) { return s.c[i][j][l] * s.c[a][b][d]; };
    EXPECT_NEAR(even[kSecondFormVariation], sum_over_indices([&](int i, int j, int l, int a, int b, int d) {
                  return i == a && j == b && l == d ? c2(i, j, l, a, b, d) : 0;
                }),
                1e-14 * unit);
    EXPECT_NEAR(even[kMeanCurvatureVariation], s.t[0] * s.t[0] + s.t[1] * s.t[1], 1e-14 * unit);
    EXPECT_NEAR(even[kCurvednessVariation], s.v[0] * s.v[0] + s.v[1] * s.v[1], 1e-14 * bending * unit);
    double gradient_form = 0;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) gradient_form += s.h[i][j] * s.t[i] * s.t[j];
    }
    EXPECT_NEAR(odd[kGradientForm], gradient_form, 1e-13 * root * unit);
    EXPECT_NEAR(odd[kVariationForm], sum_over_indices([&](int i, int j, int l, int a, int b, int d) {
                  return j == b && l == d ? s.h[i][a] * c2(i, j, l, a, b, d) : 0;
                }),
                1e-13 * root * unit);
    EXPECT_NEAR(odd[kTripleForm], sum_over_indices([&](int i, int j, int l, int a, int b, int d) {
                  return s.h[i][a] * s.h[j][b] * s.h[l][d] * c2(i, j, l, a, b, d);
                }),
                1e-13 * root * bending * unit);
  }
}

TEST(Invariants, that_are_even_make_the_densities_of_mehlum_tarrou_mvs_and_mvs_cross) {
  Random random(2);
  int away_from_umbilics = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Curvature<double> k = curvature(random_jet(random));
    const Tensors s(k);
    const DensityValues even = densities(k);
    const double j1 = even[kSecondFormVariation], j2 = even[kMeanCurvatureVariation];
    EXPECT_NEAR(even[kMehlumTarrou], (2 * j1 + 3 * j2) / 16, 1e-12 * even[kMehlumTarrou]);

    const double mean = (k.p + k.r) / 2, deviation2 = mean * mean - (k.p * k.r - k.q * k.q);
    if (deviation2 < 0.01 * even[kBending]) continue;
    ++away_from_umbilics;
    // Without the regularization at umbilics, which changes 1e-12 of them.
    const PrincipalAngle<double> angle(k, 0);
    Curvature<double> unused;
    const double mvs = mvs_density(k, angle, 0.0, unused), cross = mvs_cross_density(k, angle, 0.0, unused);
    EXPECT_NEAR(mvs, (3 * cross - j1) / 2, 1e-12 * cross);
    const double x = s.v[0] - mean * s.t[0], y = s.v[1] - mean * s.t[1];
    EXPECT_NEAR(cross, j2 / 2 + (x * x + y * y) / (2 * deviation2), 1e-12 * cross);
  }
  EXPECT_GT(away_from_umbilics, 50);
}

TEST(Invariants, that_are_even_make_the_energies_of_mehlum_tarrou_and_mvs) {
  // The regularization at umbilics changes 1e-12 of mvs and mvs_cross where there are none, and more around each.
  struct Surface {
    const char* name;
    int level;
    double regularization;
  };
  for (const auto& [name, level, regularization] : {Surface{"torus", 0, 1e-11}, {"cube", 2, 1e-8}, {"g2", 2, 1e-9}}) {
    const Refined mesh = refined(reference_cage(name), level);
    for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat}) {
      const PatchLayout layout(mesh.mesh, cap);
      const auto e = surface_integrals(JetEvaluator(layout, {4, 5, 2}), mesh.control).functionals;
      const double j1 = e[kSecondFormVariation], j2 = e[kMeanCurvatureVariation];
      EXPECT_NEAR(e[kMehlumTarrou], (2 * j1 + 3 * j2) / 16, 1e-12 * e[kMehlumTarrou]) << name;
      EXPECT_NEAR(e[kMvs], (3 * e[kMvsCross] - j1) / 2, regularization * e[kMvsCross]) << name;
    }
  }
}

TEST(Invariants, that_are_odd_turn_with_the_surface_change_sign_with_its_side_and_scale_by_5_5_and_7) {
  Random random(3);
  const double scale = 2.5;
  for (int trial = 0; trial < 30; ++trial) {
    const Jet<double> jet = random_jet(random);
    Jet<double> moved = jet, other_side = jet;
    for (Vec3<double>* v : vectors(moved)) *v = vec3(scale * some_rotation() * vector(*v));
    std::swap(other_side.first[0], other_side.first[1]);
    std::swap(other_side.second[0], other_side.second[2]);
    std::swap(other_side.third[0], other_side.third[3]);
    std::swap(other_side.third[1], other_side.third[2]);
    const InvariantDensities plain = odd_densities(curvature(jet)), turned = odd_densities(curvature(moved)),
                             opposite = odd_densities(curvature(other_side));
    const DensityValues even = densities(jet);
    const double unit = std::sqrt(even[kBending]) * even[kSecondFormVariation];
    for (int i = 0; i < kInvariantCount; ++i) {
      const bool triple = i == kTripleForm;
      const double size = 1e-12 * unit * (triple ? even[kBending] : 1);
      EXPECT_NEAR(turned[i] * std::pow(scale, triple ? 7 : 5), plain[i], size) << kInvariantNames[i];
      EXPECT_NEAR(opposite[i], -plain[i], size) << kInvariantNames[i];
    }
  }
}

/// Of the torus whose tube has this radius about a circle of radius 1, with II positive on its outside.
InvariantDensities torus_invariants(double a) {
  const double root = std::sqrt(a), b = 1 - a * a;
  InvariantDensities values;
  values[kGradientForm] = 16 * std::pow(pi, 5) / root * std::pow(b, -1.5);
  values[kVariationForm] = 16 * std::pow(pi, 5) / root * (1 - 3 * a * a) * std::pow(b, -2.5);
  values[kTripleForm] = 48 * std::pow(pi, 7) * root * (1 + 4 * a * a) * std::pow(b, -3.5);
  return values;
}

TEST(Invariants, of_tori_are_their_closed_forms) {
  for (const double a : {0.05, 0.3, 0.6, 0.9}) {
    constexpr int kNodes = 400;  // converges exponentially
    InvariantDensities sums{};
    double area = 0;
    for (int i = 0; i < kNodes; ++i) {
      const double latitude = 2 * pi * i / kNodes;
      const auto [u, v] = curved_parameters(0.3, latitude);
      const Taylor radius = 1 + a * cos(v);
      const Curvature<double> k = curvature(jet_of({radius * cos(u), radius * sin(u), a * sin(v)}));
      const double measure = (1 + a * std::cos(latitude)) * a * 4 * pi * pi / kNodes;
      const InvariantDensities values = odd_densities(k);
      for (int f = 0; f < kInvariantCount; ++f) sums[f] += measure * values[f];
      area += measure;
    }
    const InvariantDensities exact = torus_invariants(a);
    // The parameters' normal may point to either side.
    const double side = sums[kGradientForm] > 0 ? 1 : -1;
    for (int i = 0; i < kInvariantCount; ++i) {
      const double value = side * sums[i] * std::pow(area, area_exponent(static_cast<Invariant>(i)));
      EXPECT_NEAR(value, exact[i], 1e-10 * exact[kTripleForm]) << kInvariantNames[i] << a;
    }
  }
}

TEST(Invariants, of_meshed_tori_approach_their_closed_forms_as_the_square_of_the_mesh_width) {
  for (const double a : {0.3, 0.6}) {
    const InvariantDensities exact = torus_invariants(a);
    InvariantDensities before{};
    for (const int segments : {32, 64, 128}) {
      const Cage cage = *generate_cage("torus", {.ratio = a, .major_segments = segments, .minor_segments = segments});
      const PatchLayout layout(PolygonMesh(cage), CapKind::kNone);
      const auto sums = surface_integrals(JetEvaluator(layout, {6, 6, 0}), cage.vertices).invariants;
      for (int i = 0; i < kInvariantCount; ++i) {
        const double error = std::abs(sums[i] - exact[i]);
        if (segments > 32) {
          EXPECT_LT(error, 0.3 * before[i]) << kInvariantNames[i] << " on " << segments;
        }
        before[i] = error;
      }
    }
  }
}

TEST(Invariants, vanish_on_spheres) {
  const auto [u, v] = curved_parameters(0.5, 0.3);
  const Curvature<double> sphere = curvature(jet_of({cos(v) * cos(u), cos(v) * sin(u), sin(v)}));
  for (const double value : odd_densities(sphere)) EXPECT_LT(std::abs(value), 1e-20);
  EXPECT_LT(densities(sphere)[kMeanCurvatureVariation], 1e-20);
  EXPECT_LT(densities(sphere)[kCurvednessVariation], 1e-20);
}

}  // namespace
}  // namespace umbilic::test
