// SPDX-License-Identifier: MIT
/// \file
/// Second derivatives of the integrand by the jet, against dual numbers run through its gradient and what invariance
/// asks of them.
#include "energy/kernels/jet_hessian.h"

#include <gtest/gtest.h>

#include "energy/density_values.h"
#include "energy/dual.h"

namespace umbilic::test {
namespace {

constexpr double kWeight = 0.7;

/// Each functional alone with an area term, then blends.
std::vector<WeightedIntegrand> integrands() {
  std::vector<WeightedIntegrand> all;
  for (int f = 0; f < kFunctionalCount; ++f) {
    WeightedIntegrand single{{}, is_third_order(f), 0.3};
    single.weights[f] = 1.2;
    all.push_back(single);
  }
  all.push_back({{0.5, 0.25, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, true, 2});
  all.push_back({{0.5, 0.25, 0, 0, 0, 0}, false, 0});
  WeightedIntegrand even[] = {{{0.5, 0, 0, 0.2}, true, 2}, {{0.5, 0.25}, false, 0.1}, {{}, false, 0}};
  for (WeightedIntegrand& f : even) {
    f.weights[kParametrization] = 0.6;
    all.push_back(f);
  }
  return all;
}

template <bool kThird, bool kChristoffel = false>
Eigen::MatrixXd hessian(const WeightedIntegrand& f, const Jet<double>& jet) {
  const JetHessian<kThird, kChristoffel, double> hessian(f, jet, kWeight);
  constexpr int kSize = JetHessian<kThird, kChristoffel, double>::kSize;
  Eigen::MatrixXd matrix(kSize, kSize);
  for (int i = 0; i < kSize; ++i) {
    for (int j = 0; j < kSize; ++j) matrix(i, j) = hessian(i, j);
  }
  return matrix;
}

/// The i-th column by dual numbers of one tangent through all nine vectors, which knows of no shortcut.
template <bool kThird, bool kChristoffel>
Eigen::VectorXd column(const WeightedIntegrand& f, Jet<double> jet, int i) {
  constexpr int kDerivatives = JetHessian<kThird, kChristoffel, double>::kDerivatives;
  Jet<Dual> moved;
  const auto from = vectors(jet);
  const auto to = vectors(moved);
  for (int d = 0; d < 9; ++d) *to[d] = {Dual(from[d]->x), Dual(from[d]->y), Dual(from[d]->z)};
  Vec3<Dual>& direction = *to[i % kDerivatives];
  (i / kDerivatives == 0 ? direction.x : i / kDerivatives == 1 ? direction.y : direction.z).dx = 1;
  Jet<Dual> gradient = integrand_gradient<kThird, kChristoffel>(f, moved, Dual(kWeight));
  Eigen::VectorXd result(3 * kDerivatives);
  for (int d = 0; d < kDerivatives; ++d) {
    const Vec3<Dual>& v = *vectors(gradient)[d];
    result[d] = v.x.dx;
    result[kDerivatives + d] = v.y.dx;
    result[2 * kDerivatives + d] = v.z.dx;
  }
  return result;
}

template <bool kThird, bool kChristoffel>
void expect_derivative_of_the_gradient(const WeightedIntegrand& f) {
  Random random(6);
  for (int trial = 0; trial < 10; ++trial) {
    const Jet<double> jet = random_jet(random);
    const Eigen::MatrixXd matrix = hessian<kThird, kChristoffel>(f, jet);
    const double size = matrix.cwiseAbs().maxCoeff();
    EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-11 * size);
    for (int i = 0; i < matrix.cols(); ++i) {
      EXPECT_LT((matrix.col(i) - column<kThird, kChristoffel>(f, jet, i)).cwiseAbs().maxCoeff(), 1e-10 * size)
          << "column " << i;
    }
  }
}

TEST(JetHessian, is_symmetric_and_the_derivative_of_the_gradient_for_every_functional) {
  for (const WeightedIntegrand& f : integrands()) {
    if (f.weights[kParametrization] != 0) {
      f.third_order ? expect_derivative_of_the_gradient<true, true>(f)
                    : expect_derivative_of_the_gradient<false, true>(f);
    } else {
      f.third_order ? expect_derivative_of_the_gradient<true, false>(f)
                    : expect_derivative_of_the_gradient<false, false>(f);
    }
  }
}

TEST(JetHessian, of_second_order_functionals_through_order_three_is_that_through_order_two_and_zeros) {
  Random random(7);
  const WeightedIntegrand second{{0.5, 0.25, 0, 0, 0, 0}, false, 0.4};
  const Jet<double> jet = random_jet(random);
  const Eigen::MatrixXd small = hessian<false>(second, jet), large = hessian<true>(second, jet);
  const double size = small.cwiseAbs().maxCoeff();
  for (int i = 0; i < large.rows(); ++i) {
    for (int j = 0; j < large.cols(); ++j) {
      const bool inside = i % 9 < 5 && j % 9 < 5;
      const double expected = inside ? small(i / 9 * 5 + i % 9, j / 9 * 5 + j % 9) : 0;
      EXPECT_NEAR(large(i, j), expected, 1e-12 * size);
    }
  }
}

/// Densities times area elements have degree -2p in the size of the surface, p the functional's power of the area:
/// Euler's theorem for the gradient, which has one degree less.
TEST(JetHessian, times_the_jet_is_the_gradient_times_its_degree) {
  Random random(8);
  for (int f = 0; f < kFunctionalCount; ++f) {
    WeightedIntegrand single{{}, is_third_order(f), 0};
    single.weights[f] = 1;
    Jet<double> jet = random_jet(random);
    const int derivatives = is_third_order(f) ? 9 : 5;
    const Eigen::MatrixXd matrix = is_third_order(f) ? hessian<true>(single, jet) : hessian<false>(single, jet);
    Jet<double> slope = is_third_order(f) ? integrand_gradient<true, false>(single, jet, kWeight)
                                          : integrand_gradient<false, false>(single, jet, kWeight);
    Eigen::VectorXd x(3 * derivatives), gradient(3 * derivatives);
    for (int d = 0; d < derivatives; ++d) {
      for (int c = 0; c < 3; ++c) {
        x[c * derivatives + d] = vector(*vectors(jet)[d])[c];
        gradient[c * derivatives + d] = vector(*vectors(slope)[d])[c];
      }
    }
    const double degree = -2 * area_power(f);
    EXPECT_LT((matrix * x - (degree - 1) * gradient).norm(), 1e-10 * gradient.norm()) << kFunctionalNames[f];
  }
}

}  // namespace
}  // namespace umbilic::test
