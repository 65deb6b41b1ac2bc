// SPDX-License-Identifier: MIT
/// \file
/// Second derivatives of a weighted sum of densities by the jet: the gradient's code, evaluated on dual numbers.
///
/// f(jet) = weight (rho + area_slope) |X_u x X_v|. Structure saves most of the work. C depends linearly on the third
/// derivatives, and only on their normal parts, so the block of the third derivatives is n n^T times a 4 x 4 matrix of
/// the density; only the first and second derivatives need dual numbers. If f does not depend on C, the same holds for
/// II and the second derivatives, and only the first derivatives need them.
#pragma once

#include "energy/densities.h"
#include "energy/hessian_patch.h"
#include "energy/kernels/dual_number.h"
#include "surface/derivative_order.h"

namespace umbilic::UMBILIC_KERNELS {

/// The gradient of f.
template <bool kThird, bool kChristoffel, class T>
Jet<T> integrand_gradient(const WeightedIntegrand& f, const Jet<T>& jet, const T& weight) {
  const CurvatureFrame<T, kThird, kThird || kChristoffel> frame(jet);
  const Curvature<T>& k = frame.value();
  Curvature<T> adjoint{};
  const T measure = weight * k.area;
  T density = weighted_density<0>(f.weights, k, measure, adjoint);
  if constexpr (kThird) density += third_order_density(f.weights, k, measure, adjoint, f.umbilic_eta);
  if constexpr (kChristoffel) {
    const double parametrization = f.weights[kParametrization];
    density += parametrization * parametrization_density(k, measure * parametrization, adjoint);
  }
  adjoint.area = weight * (density + f.area_slope);
  return frame.template pull_back<kThird, kChristoffel>(adjoint);
}

/// Entry (i, j) with i and j counting c * derivatives + d, where d = 0 is X_u and derivatives = kThird ? 9 : 5.
template <bool kThird, bool kChristoffel, class T>
class JetHessian {
 public:
  static constexpr int kDerivatives = kThird ? kThirdOrderCount : kSecondOrderCount;
  static constexpr int kSize = 3 * kDerivatives;

  JetHessian(const WeightedIntegrand& f, const Jet<T>& jet, const T& weight) {
    constexpr int kDirections = kThird || kChristoffel ? kSecondOrderCount : kFirstOrderCount;
    for (int d = 0; d < kDirections; ++d) along_derivative(f, jet, weight, d);
    if constexpr (kThird) {
      along_third(f, jet, weight);
    } else if constexpr (!kChristoffel) {
      along_second(f, jet, weight);
    }
  }

  const T& operator()(int i, int j) const { return entries_[i][j]; }

 private:
  static int index(int d, int coordinate) { return coordinate * kDerivatives + d; }

  /// Columns and rows of the three coordinates of a first or second derivative.
  void along_derivative(const WeightedIntegrand& f, const Jet<T>& jet, const T& weight, int d) {
    using Number = DualNumber<T, 3>;
    Jet<Number> moved;
    const auto lift = [](const Vec3<T>& v) { return Vec3<Number>{Number(v.x), Number(v.y), Number(v.z)}; };
    for (int i = 0; i < 2; ++i) moved.first[i] = lift(jet.first[i]);
    for (int i = 0; i < 3; ++i) moved.second[i] = lift(jet.second[i]);
    if constexpr (kThird) {
      for (int i = 0; i < 4; ++i) moved.third[i] = lift(jet.third[i]);
    }
    Vec3<Number>& direction = d < 2 ? moved.first[d] : moved.second[d - 2];
    direction.x.tangent[0] += 1.0;
    direction.y.tangent[1] += 1.0;
    direction.z.tangent[2] += 1.0;
    const Jet<Number> gradient = integrand_gradient<kThird, kChristoffel>(f, moved, Number(weight));
    const auto store = [&](int row, const Vec3<Number>& v) {
      for (int c = 0; c < 3; ++c) {
        const T entries[3] = {v.x.tangent[c], v.y.tangent[c], v.z.tangent[c]};
        for (int r = 0; r < 3; ++r)
          entries_[index(row, r)][index(d, c)] = entries_[index(d, c)][index(row, r)] = entries[r];
      }
    };
    for (int i = 0; i < 2; ++i) store(i, gradient.first[i]);
    for (int i = 0; i < 3; ++i) store(2 + i, gradient.second[i]);
    if constexpr (kThird) {
      for (int i = 0; i < 4; ++i) store(5 + i, gradient.third[i]);
    }
  }

  /// The block of the second derivatives, if f does not depend on C.
  void along_second(const WeightedIntegrand& f, const Jet<T>& jet, const T& weight) {
    const CurvatureFrame<T, false> frame(jet);
    const Curvature<T>& k = frame.value();
    using Number = DualNumber<T, 3>;
    Curvature<Number> moved, adjoint{};
    moved.p = Number(k.p);
    moved.q = Number(k.q);
    moved.r = Number(k.r);
    for (int i = 0; i < 3; ++i) {
      T x[3] = {}, form[3];
      x[i] += 1.0;
      frame.second_to_frame(x, form);
      moved.p.tangent[i] = form[0];
      moved.q.tangent[i] = form[1];
      moved.r.tangent[i] = form[2];
    }
    weighted_density<0>(f.weights, moved, Number(weight * k.area), adjoint);
    for (int i = 0; i < 3; ++i) {
      const T form[3] = {adjoint.p.tangent[i], adjoint.q.tangent[i], adjoint.r.tangent[i]};
      T x[3];
      frame.second_from_frame(form, x);
      store_normal_block(frame.normal(), 2 + i, 2, x);
    }
  }

  /// The block of the third derivatives.
  void along_third(const WeightedIntegrand& f, const Jet<T>& jet, const T& weight) {
    const CurvatureFrame<T, true> frame(jet);
    const Curvature<T>& k = frame.value();
    using Number = DualNumber<T, 4>;
    Curvature<Number> moved, adjoint{};
    moved.p = Number(k.p);
    moved.q = Number(k.q);
    moved.r = Number(k.r);
    for (int i = 0; i < 4; ++i) moved.c[i] = Number(k.c[i]);
    for (int i = 0; i < 4; ++i) {
      T t[4] = {}, c[4];
      t[i] += 1.0;
      frame.third_to_frame(t, c);
      for (int j = 0; j < 4; ++j) moved.c[j].tangent[i] = c[j];
    }
    third_order_density(f.weights, moved, Number(weight * k.area), adjoint, f.umbilic_eta);
    for (int i = 0; i < 4; ++i) {
      T c[4], t[4];
      for (int j = 0; j < 4; ++j) c[j] = adjoint.c[j].tangent[i];
      frame.third_from_frame(c, t);
      store_normal_block(frame.normal(), 5 + i, 5, t);
    }
  }

  /// The entries n n^T t[j] between the derivatives d and first + j.
  template <int kCount>
  void store_normal_block(const Vec3<T>& normal, int d, int first, const T (&t)[kCount]) {
    const T n[3] = {normal.x, normal.y, normal.z};
    for (int j = 0; j < kCount; ++j) {
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) entries_[index(d, a)][index(first + j, b)] = n[a] * n[b] * t[j];
      }
    }
  }

  T entries_[kSize][kSize];
};

}  // namespace umbilic::UMBILIC_KERNELS
