// SPDX-License-Identifier: MIT
/// \file
/// Covariant derivatives of coordinate functions, which the fundamental forms give in closed form.
#include "optimize/covariant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "energy/curvature.h"

namespace umbilic {
namespace {

using JetRows = Eigen::Matrix<double, kThirdOrderCount, 3>;

JetRows random_jet(int seed) {
  std::mt19937 random(seed);
  JetRows jet;
  for (int i = 0; i < jet.size(); ++i) jet.data()[i] = 2.0 * random() / std::mt19937::max() - 1;
  return jet;
}

Vec3<double> vec(const Eigen::RowVector3d& v) { return {v[0], v[1], v[2]}; }

Jet<double> to_jet(const JetRows& rows) {
  Jet<double> jet;
  for (int i = 0; i < 2; ++i) jet.first[i] = vec(rows.row(i));
  for (int i = 0; i < 3; ++i) jet.second[i] = vec(rows.row(2 + i));
  for (int i = 0; i < 4; ++i) jet.third[i] = vec(rows.row(5 + i));
  return jet;
}

/// For f = a . X: grad^2 f = II (a . n) and (grad^3 f)_kij = C_ijk (a . n) - II_ij II_km (a . e_m), in the frame of
/// CurvatureFrame.
TEST(CovariantDerivatives, of_coordinate_functions_are_given_by_the_second_fundamental_form_and_its_derivative) {
  for (int seed = 1; seed <= 20; ++seed) {
    const JetRows rows = random_jet(seed);
    const Jet<double> jet = to_jet(rows);
    const CurvatureFrame<double, true> frame(jet);
    const Curvature<double>& k = frame.value();
    const CovariantDerivatives covariant(rows);
    const Vector3 n(frame.normal().x, frame.normal().y, frame.normal().z);
    const Vector3 e1 = rows.row(0).normalized(), e2 = n.cross(e1);
    const double form[2][2] = {{k.p, k.q}, {k.q, k.r}};
    const double root = std::sqrt(2.0);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Matrix<double, kThirdOrderCount, 1> f = rows.col(axis);
      const Eigen::Vector3d second = covariant.second * f;
      const double scale = rows.norm() * (1 + std::abs(k.p) + std::abs(k.r));
      EXPECT_NEAR(second[0], k.p * n[axis], 1e-11 * scale);
      EXPECT_NEAR(second[1], root * k.q * n[axis], 1e-11 * scale);
      EXPECT_NEAR(second[2], k.r * n[axis], 1e-11 * scale);
      const Eigen::Matrix<double, 6, 1> third = covariant.third * f;
      for (int by = 0; by < 2; ++by) {
        const double tangential = form[by][0] * e1[axis] + form[by][1] * e2[axis];
        const double expected[3] = {k.c[by] * n[axis] - k.p * tangential,
                                    root * (k.c[by + 1] * n[axis] - k.q * tangential),
                                    k.c[by + 2] * n[axis] - k.r * tangential};
        for (int i = 0; i < 3; ++i) {
          EXPECT_NEAR(third[3 * by + i], expected[i], 1e-9 * scale * (1 + std::abs(expected[i])));
        }
      }
    }
    EXPECT_NEAR(covariant.area, k.area, 1e-14 * k.area);
  }
}

TEST(CovariantDerivatives, of_a_constant_vanish_and_norms_do_not_depend_on_the_parametrization) {
  const JetRows rows = random_jet(7);
  // Linear reparametrization (u, v) -> (2u + v, 3v - u) of surface and function alike.
  const double m[2][2] = {{2, -1}, {1, 3}};
  Eigen::Matrix<double, kThirdOrderCount, kThirdOrderCount> change = decltype(change)::Zero();
  const auto at = [](int order, int l) { return order == 1 ? l : order == 2 ? 2 + l : 5 + l; };
  for (int order = 1; order <= 3; ++order) {
    for (int bits = 0; bits < 1 << order; ++bits) {
      for (int old = 0; old < 1 << order; ++old) {
        double factor = 1;
        int l_new = 0, l_old = 0;
        for (int i = 0; i < order; ++i) {
          const int to = bits >> i & 1, from = old >> i & 1;
          factor *= m[from][to];
          l_new += to;
          l_old += from;
        }
        const int multiplicity = order == 1 || l_new == 0 || l_new == order ? 1 : order;
        change(at(order, l_new), at(order, l_old)) += factor / multiplicity;
      }
    }
  }
  const Eigen::Matrix<double, kThirdOrderCount, 1> f = random_jet(8).col(0);
  const CovariantDerivatives a(rows), b(change * rows);
  EXPECT_NEAR((a.second * f).norm(), (b.second * (change * f)).norm(), 1e-11 * (a.second * f).norm());
  EXPECT_NEAR((a.third * f).norm(), (b.third * (change * f)).norm(), 1e-10 * (a.third * f).norm());
}

}  // namespace
}  // namespace umbilic
