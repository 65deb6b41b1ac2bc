// SPDX-License-Identifier: MIT
/// \file
/// From a jet to the second fundamental form and its covariant derivative in an orthonormal frame, and the pullback.
///
/// paper / DESIGN | code
/// X_u, X_v            | jet.first[0], jet.first[1]
/// X_uu, X_uv, X_vv    | jet.second[0..2]
/// X_uuu, …, X_vvv     | jet.third[0..3]
/// II = (p, q, r)      | p, q, r                    in the frame e1 = X_u/|X_u|, e2 = n x e1
/// C = (c0, …, c3)     | c[0..3]                    C_ijk = (covariant derivative of II)(e_i, e_j, e_k)
/// dA = du dv |Xu x Xv|| area
///
/// e1 = alpha X_u and e2 = beta X_u + gamma X_v. Y denotes X reparametrized linearly so that e1 and e2 are its
/// parameter directions. Then the metric is the identity at the point and the Christoffel symbols are dot products:
///
///   christoffel[m][ij] = e_m . Y_ij
///   C_ijk = n . Y_ijk - christoffel[m][ij] II_mk - christoffel[m][jk] II_mi - christoffel[m][ki] II_mj
///
/// T is double, a vector of lanes (several samples), or a dual number.
#pragma once

#include "base/lanes.h"
#include "energy/vector3.h"

namespace umbilic::UMBILIC_KERNELS {

template <class T>
struct Jet {
  Vec3<T> first[2], second[3], third[4];
};

/// What densities are functions of. Also holds adjoints: the derivatives by these numbers.
template <class T>
struct Curvature {
  T p{}, q{}, r{};
  T c[4]{};
  T area{};
  T christoffel[2][3]{};  ///< [m][ij]: e_m . Y_ij
};

/// The curvature of a jet, with what its pullback needs. Without kThird, C is left out.
template <class T, bool kThird, bool kChristoffel = kThird>
class CurvatureFrame {
 public:
  explicit CurvatureFrame(const Jet<T>& jet) : jet_(jet) {
    const Vec3<T>&a = jet.first[0], &b = jet.first[1];
    const T e = dot(a, a);
    f_ = dot(a, b);
    const Vec3<T> w = cross(a, b);
    value_.area = sqrt(dot(w, w));
    normal_ = w * (1.0 / value_.area);
    alpha_ = 1.0 / sqrt(e);
    gamma_ = e * alpha_ / value_.area;
    beta_ = -f_ * alpha_ / value_.area;

    for (int i = 0; i < 3; ++i) along_normal_[i] = dot(normal_, jet.second[i]);
    T form[3];
    to_frame(along_normal_, form);
    value_.p = form[0];
    value_.q = form[1];
    value_.r = form[2];
    if constexpr (kChristoffel) christoffel_symbols();
    if constexpr (kThird) covariant_derivative();
  }

  const Curvature<T>& value() const { return value_; }
  const Vec3<T>& normal() const { return normal_; }

  /// The adjoint of the jet from the adjoint of its curvature. Without kWithThird, the adjoint of C counts as zero.
  template <bool kWithThird = kThird, bool kWithChristoffel = false>
  Jet<T> pull_back(const Curvature<T>& adjoint) const;

  /// II from x = n . X_ij, and the transpose.
  void second_to_frame(const T (&x)[3], T (&form)[3]) const { to_frame(x, form); }
  void second_from_frame(const T (&form)[3], T (&x)[3]) const {
    x[0] = alpha_ * (alpha_ * form[0] + beta_ * form[1]) + beta_ * beta_ * form[2];
    x[1] = gamma_ * (alpha_ * form[1] + 2.0 * beta_ * form[2]);
    x[2] = gamma_ * gamma_ * form[2];
  }

  /// The part of C that is linear in t = n . X_ijk, and the transpose.
  void third_to_frame(const T (&t)[4], T (&c)[4]) const {
    const T t01 = beta_ * t[0] + gamma_ * t[1], t12 = beta_ * t[1] + gamma_ * t[2], t23 = beta_ * t[2] + gamma_ * t[3];
    const T t012 = beta_ * t01 + gamma_ * t12, t123 = beta_ * t12 + gamma_ * t23;
    c[0] = alpha_ * alpha_ * alpha_ * t[0];
    c[1] = alpha_ * alpha_ * t01;
    c[2] = alpha_ * t012;
    c[3] = beta_ * t012 + gamma_ * t123;
  }
  void third_from_frame(const T (&c)[4], T (&t)[4]) const {
    const T aa = alpha_ * alpha_;
    // Horner's scheme, from the highest power of beta.
    t[0] = alpha_ * (aa * c[0] + beta_ * (alpha_ * c[1] + beta_ * c[2])) + beta_ * beta_ * beta_ * c[3];
    t[1] = gamma_ * (aa * c[1] + beta_ * (2.0 * alpha_ * c[2] + 3.0 * beta_ * c[3]));
    t[2] = gamma_ * gamma_ * (alpha_ * c[2] + 3.0 * beta_ * c[3]);
    t[3] = gamma_ * gamma_ * gamma_ * c[3];
  }

 private:
  void to_frame(const T (&x)[3], T (&y)[3]) const {
    const T mixed = beta_ * x[0] + gamma_ * x[1];
    y[0] = alpha_ * alpha_ * x[0];
    y[1] = alpha_ * mixed;
    y[2] = beta_ * mixed + gamma_ * (beta_ * x[1] + gamma_ * x[2]);
  }

  struct FrameAdjoint {
    T alpha{}, beta{}, gamma{};
  };

  void pull_back_to_frame(const T (&x)[3], const T (&y_adjoint)[3], T (&x_adjoint)[3], FrameAdjoint& frame) const {
    const T mixed = beta_ * x[0] + gamma_ * x[1], last = beta_ * x[1] + gamma_ * x[2];
    second_from_frame(y_adjoint, x_adjoint);
    frame.alpha += 2.0 * alpha_ * x[0] * y_adjoint[0] + mixed * y_adjoint[1];
    frame.beta += alpha_ * x[0] * y_adjoint[1] + 2.0 * mixed * y_adjoint[2];
    frame.gamma += alpha_ * x[1] * y_adjoint[1] + 2.0 * last * y_adjoint[2];
  }

  void christoffel_symbols() {
    for (int i = 0; i < 3; ++i) {
      along_first_[0][i] = dot(jet_.first[0], jet_.second[i]);
      along_first_[1][i] = dot(jet_.first[1], jet_.second[i]);
      along_frame_[0][i] = alpha_ * along_first_[0][i];
      along_frame_[1][i] = beta_ * along_first_[0][i] + gamma_ * along_first_[1][i];
    }
    to_frame(along_frame_[0], value_.christoffel[0]);
    to_frame(along_frame_[1], value_.christoffel[1]);
  }

  void covariant_derivative() {
    for (int i = 0; i < 4; ++i) third_normal_[i] = dot(normal_, jet_.third[i]);

    const T &p = value_.p, &q = value_.q, &r = value_.r;
    const T(&g1)[3] = value_.christoffel[0];
    const T(&g2)[3] = value_.christoffel[1];
    T c[4];
    third_to_frame(third_normal_, c);
    value_.c[0] = c[0] - 3.0 * (g1[0] * p + g2[0] * q);
    value_.c[1] = c[1] - (g1[0] * q + g2[0] * r) - 2.0 * (g1[1] * p + g2[1] * q);
    value_.c[2] = c[2] - 2.0 * (g1[1] * q + g2[1] * r) - (g1[2] * p + g2[2] * q);
    value_.c[3] = c[3] - 3.0 * (g1[2] * q + g2[2] * r);
  }

  const Jet<T>& jet_;
  Curvature<T> value_;
  Vec3<T> normal_;
  T f_, alpha_, beta_, gamma_;
  T along_normal_[3];    // n . X_ij
  T along_first_[2][3];  // X_m . X_ij
  T along_frame_[2][3];  // e_m . X_ij
  T third_normal_[4];    // n . X_ijk
};

template <class T, bool kThird, bool kChristoffel>
template <bool kWithThird, bool kWithChristoffel>
Jet<T> CurvatureFrame<T, kThird, kChristoffel>::pull_back(const Curvature<T>& adjoint) const {
  Jet<T> jet{};
  FrameAdjoint frame;
  Vec3<T> normal_adjoint{};
  T p = adjoint.p, q = adjoint.q, r = adjoint.r;
  T christoffel_adjoint[2][3] = {};
  if constexpr (kWithChristoffel) {
    for (int m = 0; m < 2; ++m) {
      for (int i = 0; i < 3; ++i) christoffel_adjoint[m][i] = adjoint.christoffel[m][i];
    }
  }

  if constexpr (kWithThird) {
    const T(&c)[4] = adjoint.c;
    const T(&g1)[3] = value_.christoffel[0];
    const T(&g2)[3] = value_.christoffel[1];
    p -= 3.0 * g1[0] * c[0] + 2.0 * g1[1] * c[1] + g1[2] * c[2];
    q -= 3.0 * g2[0] * c[0] + (g1[0] + 2.0 * g2[1]) * c[1] + (2.0 * g1[1] + g2[2]) * c[2] + 3.0 * g1[2] * c[3];
    r -= g2[0] * c[1] + 2.0 * g2[1] * c[2] + 3.0 * g2[2] * c[3];
    const T &vp = value_.p, &vq = value_.q, &vr = value_.r;
    christoffel_adjoint[0][0] -= 3.0 * vp * c[0] + vq * c[1];
    christoffel_adjoint[0][1] -= 2.0 * (vp * c[1] + vq * c[2]);
    christoffel_adjoint[0][2] -= vp * c[2] + 3.0 * vq * c[3];
    christoffel_adjoint[1][0] -= 3.0 * vq * c[0] + vr * c[1];
    christoffel_adjoint[1][1] -= 2.0 * (vq * c[1] + vr * c[2]);
    christoffel_adjoint[1][2] -= vq * c[2] + 3.0 * vr * c[3];

    const T(&t)[4] = third_normal_;
    const T t01 = beta_ * t[0] + gamma_ * t[1], t12 = beta_ * t[1] + gamma_ * t[2], t23 = beta_ * t[2] + gamma_ * t[3];
    const T t012 = beta_ * t01 + gamma_ * t12, t123 = beta_ * t12 + gamma_ * t23;
    const T aa = alpha_ * alpha_;
    frame.alpha += 3.0 * aa * t[0] * c[0] + 2.0 * alpha_ * t01 * c[1] + t012 * c[2];
    frame.beta += aa * t[0] * c[1] + 2.0 * alpha_ * t01 * c[2] + 3.0 * t012 * c[3];
    frame.gamma += aa * t[1] * c[1] + 2.0 * alpha_ * t12 * c[2] + 3.0 * t123 * c[3];
    T third_adjoint[4];
    third_from_frame(c, third_adjoint);
    for (int i = 0; i < 4; ++i) {
      jet.third[i] = normal_ * third_adjoint[i];
      normal_adjoint += jet_.third[i] * third_adjoint[i];
    }
  }

  if constexpr (kWithThird || kWithChristoffel) {
    T frame_dot_adjoint[2][3];
    pull_back_to_frame(along_frame_[0], christoffel_adjoint[0], frame_dot_adjoint[0], frame);
    pull_back_to_frame(along_frame_[1], christoffel_adjoint[1], frame_dot_adjoint[1], frame);
    for (int i = 0; i < 3; ++i) {
      const T along_e1 = frame_dot_adjoint[0][i], along_e2 = frame_dot_adjoint[1][i];
      frame.alpha += along_first_[0][i] * along_e1;
      frame.beta += along_first_[0][i] * along_e2;
      frame.gamma += along_first_[1][i] * along_e2;
      const T a_adjoint = alpha_ * along_e1 + beta_ * along_e2, b_adjoint = gamma_ * along_e2;
      jet.second[i] = jet_.first[0] * a_adjoint + jet_.first[1] * b_adjoint;
      jet.first[0] += jet_.second[i] * a_adjoint;
      jet.first[1] += jet_.second[i] * b_adjoint;
    }
  }

  const T form_adjoint[3] = {p, q, r};
  T normal_dot_adjoint[3];
  pull_back_to_frame(along_normal_, form_adjoint, normal_dot_adjoint, frame);
  for (int i = 0; i < 3; ++i) {
    jet.second[i] += normal_ * normal_dot_adjoint[i];
    normal_adjoint += jet_.second[i] * normal_dot_adjoint[i];
  }

  const T inverse_area = 1.0 / value_.area;
  const T twice_e = alpha_ * inverse_area * (frame.gamma + f_ * alpha_ * alpha_ * frame.beta) -
                    alpha_ * alpha_ * alpha_ * frame.alpha;  // twice the adjoint of X_u . X_u
  const T f_adjoint = -alpha_ * inverse_area * frame.beta;
  const T area_adjoint = adjoint.area - inverse_area * (beta_ * frame.beta + gamma_ * frame.gamma);
  const Vec3<T> w_adjoint =
      normal_ * (area_adjoint - inverse_area * dot(normal_, normal_adjoint)) + normal_adjoint * inverse_area;
  const Vec3<T>&a = jet_.first[0], &b = jet_.first[1];
  jet.first[0] += a * twice_e + b * f_adjoint + cross(b, w_adjoint);
  jet.first[1] += a * f_adjoint + cross(w_adjoint, a);
  return jet;
}

}  // namespace umbilic::UMBILIC_KERNELS
