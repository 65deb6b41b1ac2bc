// SPDX-License-Identifier: MIT
/// \file
/// Hand-derived gradients against dual numbers run through the same templates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/lanes.h"
#include "energy/density_values.h"
#include "energy/dual.h"

namespace umbilic::test {
namespace {

template <class T>
Jet<T> cast(Jet<double> jet) {
  Jet<T> result;
  const auto from = vectors(jet);
  const auto to = vectors(result);
  for (int i = 0; i < 9; ++i) *to[i] = {T(from[i]->x), T(from[i]->y), T(from[i]->z)};
  return result;
}

constexpr int kEntries = 14;

template <class T>
std::array<T*, kEntries> entries(Curvature<T>& k) {
  return {&k.p,
          &k.q,
          &k.r,
          &k.c[0],
          &k.c[1],
          &k.c[2],
          &k.c[3],
          &k.area,
          &k.christoffel[0][0],
          &k.christoffel[0][1],
          &k.christoffel[0][2],
          &k.christoffel[1][0],
          &k.christoffel[1][1],
          &k.christoffel[1][2]};
}

Curvature<double> random_curvature(Random& random) {
  Curvature<double> k;
  for (double* entry : entries(k)) *entry = random();
  return k;
}

/// Each functional alone, then a blend of its order.
std::vector<Weights> weights_of_order(bool third) {
  std::vector<Weights> all;
  Weights blend{};
  for (int f = third ? kMvs : kBending; f < (third ? kFunctionalCount : kMvs); ++f) {
    Weights single{};
    single[f] = 1;
    blend[f] = 0.3 + 0.2 * f;
    all.push_back(single);
  }
  all.push_back(blend);
  return all;
}

template <class T>
T density(const Weights& weights, bool third, const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  return third ? third_order_density(weights.data(), k, scale, adjoint)
               : weighted_density<0>(weights.data(), k, scale, adjoint);
}

/// Derivative of a density by the i-th entry of the curvature.
double dual_slope(const Weights& weights, bool third, Curvature<double> k, int i) {
  Curvature<Dual> dual, unused;
  for (int j = 0; j < kEntries; ++j) *entries(dual)[j] = Dual(*entries(k)[j], i == j ? 1 : 0);
  return density(weights, third, dual, Dual(1), unused).dx;
}

TEST(Densities, gradients_by_the_curvature_equal_dual_numbers) {
  Random random(1);
  for (const bool third : {false, true}) {
    for (const Weights& weights : weights_of_order(third)) {
      for (int trial = 0; trial < 20; ++trial) {
        Curvature<double> k = random_curvature(random), adjoint;
        const double scale = 1.7;
        density(weights, third, k, scale, adjoint);
        double size = 0;
        for (int i = 0; i < kEntries; ++i) size = std::max(size, std::abs(*entries(adjoint)[i]));
        for (int i = 0; i < kEntries; ++i) {
          // Round-off; cancellation grows where the principal curvatures are close.
          EXPECT_NEAR(*entries(adjoint)[i], scale * dual_slope(weights, third, k, i), 1e-10 * size) << "entry " << i;
        }
      }
    }
  }
}

TEST(Densities, gradients_equal_dual_numbers_close_to_an_umbilic) {
  // Where D is of the size of its regularization.
  Random random(2);
  for (int trial = 0; trial < 20; ++trial) {
    Curvature<double> k = random_curvature(random), adjoint;
    k.r = k.p + 2e-6 * random();
    k.q = 1e-6 * random();
    for (const Weights& weights : weights_of_order(true)) {
      adjoint = {};
      density(weights, true, k, 1.0, adjoint);
      double size = 0;
      for (int i = 0; i < kEntries; ++i) size = std::max(size, std::abs(*entries(adjoint)[i]));
      // p - r loses ten digits to cancellation in both.
      for (int i = 0; i < kEntries; ++i)
        EXPECT_NEAR(*entries(adjoint)[i], dual_slope(weights, true, k, i), 1e-9 * size);
    }
  }
}

TEST(Densities, gradients_add_to_the_adjoint) {
  Random random(3);
  const Curvature<double> k = random_curvature(random);
  for (const bool third : {false, true}) {
    for (const Weights& weights : weights_of_order(third)) {
      Curvature<double> from_zero, start = random_curvature(random), from_start = start;
      density(weights, third, k, 1.0, from_zero);
      density(weights, third, k, 1.0, from_start);
      for (int i = 0; i < kEntries; ++i) {
        EXPECT_NEAR(*entries(from_start)[i], *entries(start)[i] + *entries(from_zero)[i], 1e-12);
      }
    }
  }
}

template <bool kThird, bool kChristoffel>
void expect_frame_pull_back() {
  Random random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const Jet<double> jet = random_jet(random);
    Curvature<double> adjoint = random_curvature(random);
    if (!kThird) {
      for (double& c : adjoint.c) c = 0;
    }
    if (!kChristoffel) {
      for (auto& row : adjoint.christoffel) std::fill(row, row + 3, 0);
    }
    using Frame = CurvatureFrame<double, kThird, kThird || kChristoffel>;
    Jet<double> gradient = Frame(jet).template pull_back<kThird, kChristoffel>(adjoint);
    double size = 0;
    for (const Vec3<double>* v : vectors(gradient)) size = std::max(size, vector(*v).cwiseAbs().maxCoeff());
    for (int i = 0; i < 9; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        Jet<Dual> dual = cast<Dual>(jet);
        Vec3<Dual>& moved = *vectors(dual)[i];
        (axis == 0 ? moved.x : axis == 1 ? moved.y : moved.z).dx = 1;
        Curvature<Dual> value = CurvatureFrame < Dual, kThird, kThird || kChristoffel > (dual).value();
        double expected = 0;
        for (int entry = 0; entry < kEntries; ++entry) expected += *entries(adjoint)[entry] * entries(value)[entry]->dx;
        EXPECT_NEAR(vector(*vectors(gradient)[i])[axis], expected, 1e-10 * size) << "vector " << i << " axis " << axis;
      }
    }
  }
}

TEST(CurvatureFrame, pull_back_through_order_3_equals_dual_numbers) { expect_frame_pull_back<true, false>(); }

TEST(CurvatureFrame, pull_back_through_order_2_equals_dual_numbers) { expect_frame_pull_back<false, false>(); }

TEST(CurvatureFrame, pull_back_with_christoffel_symbols_equals_dual_numbers) {
  expect_frame_pull_back<true, true>();
  expect_frame_pull_back<false, true>();
}

TEST(CurvatureFrame, in_lanes_gives_the_numbers_of_each_lane) {
  Random random(5);
  Jet<double> jets[kLaneCount];
  for (Jet<double>& jet : jets) jet = random_jet(random);
  Jet<Lanes> packed;
  Curvature<double> adjoint = random_curvature(random);
  Curvature<Lanes> packed_adjoint;
  for (int i = 0; i < kEntries; ++i) *entries(packed_adjoint)[i] = splat(*entries(adjoint)[i]);
  for (int lane = 0; lane < kLaneCount; ++lane) {
    for (int i = 0; i < 9; ++i) {
      Vec3<Lanes>& to = *vectors(packed)[i];
      const Vec3<double>& from = *vectors(jets[lane])[i];
      to.x[lane] = from.x;
      to.y[lane] = from.y;
      to.z[lane] = from.z;
    }
  }
  const CurvatureFrame<Lanes, true> frame(packed);
  Curvature<Lanes> value = frame.value();
  Jet<Lanes> gradient = frame.pull_back(packed_adjoint);
  for (int lane = 0; lane < kLaneCount; ++lane) {
    const CurvatureFrame<double, true> single(jets[lane]);
    Curvature<double> expected = single.value();
    Jet<double> expected_gradient = single.pull_back(adjoint);
    for (int i = 0; i < kEntries; ++i) EXPECT_DOUBLE_EQ((*entries(value)[i])[lane], *entries(expected)[i]);
    for (int i = 0; i < 9; ++i) {
      EXPECT_DOUBLE_EQ(vectors(gradient)[i]->x[lane], vectors(expected_gradient)[i]->x);
      EXPECT_DOUBLE_EQ(vectors(gradient)[i]->z[lane], vectors(expected_gradient)[i]->z);
    }
  }
}

}  // namespace
}  // namespace umbilic::test
