// SPDX-License-Identifier: MIT
/// \file
/// The integrands of all functionals as functions of II = (p, q, r) and C = (c0, …, c3), each with its gradient.
///
/// theta is the angle from e1 to the principal direction of the larger curvature kappa1, and D = (kappa1 - kappa2)/2.
/// At umbilics theta is undefined, so D is regularized, here and only here: D^2 = (p - r)^2/4 + q^2 + eta^2 (p^2 + 2
/// q^2 + r^2). Then cos 2theta = (p - r)/(2D) and sin 2theta = q/D tend smoothly to 0 at umbilics, independently of
/// frame and scale. All energies use eta = kUmbilicEta.
#pragma once

#include "energy/curvature.h"
#include "energy/functional_list.h"

namespace umbilic::UMBILIC_KERNELS {

/// Prevents 0/0 where II is zero. Smaller than any curvature whose square is representable.
inline constexpr double kFlatFloor = 1e-290;

/// cos 2theta and sin 2theta, and 1/D for their pullback.
template <class T>
struct PrincipalAngle {
  T cosine, sine, inverse_d;
  double eta2;

  explicit PrincipalAngle(const Curvature<T>& k, double eta = kUmbilicEta) : eta2(eta * eta) {
    const T half = 0.5 * (k.p - k.r);
    const T norm = k.p * k.p + 2.0 * k.q * k.q + k.r * k.r;
    inverse_d = 1.0 / sqrt(half * half + k.q * k.q + eta2 * norm + kFlatFloor);
    cosine = half * inverse_d;
    sine = k.q * inverse_d;
  }

  /// Adds to the adjoint of (p, q, r) the pullback of the adjoints of cosine and sine.
  void pull_back(const Curvature<T>& k, const T& cosine_adjoint, const T& sine_adjoint, Curvature<T>& adjoint) const {
    const T radial = -inverse_d * inverse_d * (cosine * cosine_adjoint + sine * sine_adjoint);
    const T half = 0.5 * (k.p - k.r);
    const T d_half = inverse_d * cosine_adjoint + radial * half;
    adjoint.p += 0.5 * d_half + radial * eta2 * k.p;
    adjoint.r += radial * eta2 * k.r - 0.5 * d_half;
    adjoint.q += inverse_d * sine_adjoint + radial * k.q * (1.0 + 2.0 * eta2);
  }
};

/// Each function below returns its density. `scale` is the adjoint of the density: the function adds `scale` times the
/// gradient to `adjoint`.

/// kappa1^2 + kappa2^2, in 1/length^2. Joshi & Sequin 2007, eq. 2.
template <class T>
T bending_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  adjoint.p += 2.0 * scale * k.p;
  adjoint.q += 4.0 * scale * k.q;
  adjoint.r += 2.0 * scale * k.r;
  return k.p * k.p + 2.0 * k.q * k.q + k.r * k.r;
}

/// H^2, in 1/length^2. Willmore 1965.
template <class T>
T willmore_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  const T h = 0.5 * (k.p + k.r);
  adjoint.p += scale * h;
  adjoint.r += scale * h;
  return h * h;
}

/// (dkappa1/de1)^2 + (dkappa2/de2)^2, in 1/length^4. Joshi & Sequin 2007, eq. 6. In the direction at angle t, C is h1 .
/// (cos t, sin t) + h3 . (cos 3t, sin 3t). In principal directions C_111^2 + C_222^2 = |h1|^2 + |h3|^2 + 2 Re((h1 h3)
/// e^(4 i theta)), where h1 h3 is the complex product.
template <class T>
T mvs_density(const Curvature<T>& k, const PrincipalAngle<T>& angle, const T& scale, Curvature<T>& adjoint) {
  const T x1 = 0.75 * (k.c[0] + k.c[2]), y1 = 0.75 * (k.c[1] + k.c[3]);
  const T x3 = 0.25 * (k.c[0] - 3.0 * k.c[2]), y3 = 0.25 * (3.0 * k.c[1] - k.c[3]);
  const T cos4 = angle.cosine * angle.cosine - angle.sine * angle.sine, sin4 = 2.0 * angle.cosine * angle.sine;
  const T even = x1 * x3 - y1 * y3, odd = x1 * y3 + y1 * x3;

  const T twice = 2.0 * scale;
  const T dx1 = twice * (x1 + x3 * cos4 + y3 * sin4), dy1 = twice * (y1 - y3 * cos4 + x3 * sin4);
  const T dx3 = twice * (x3 + x1 * cos4 + y1 * sin4), dy3 = twice * (y3 - y1 * cos4 + x1 * sin4);
  adjoint.c[0] += 0.75 * dx1 + 0.25 * dx3;
  adjoint.c[1] += 0.75 * (dy1 + dy3);
  adjoint.c[2] += 0.75 * (dx1 - dx3);
  adjoint.c[3] += 0.75 * dy1 - 0.25 * dy3;
  angle.pull_back(k, 2.0 * twice * (even * angle.cosine + odd * angle.sine),
                  2.0 * twice * (odd * angle.cosine - even * angle.sine), adjoint);
  return x1 * x1 + y1 * y1 + x3 * x3 + y3 * y3 + 2.0 * (even * cos4 + odd * sin4);
}

/// |grad kappa1|^2 + |grad kappa2|^2 = 2 |grad H|^2 + 2 |grad D|^2, in 1/length^4. Joshi & Sequin 2007, eq. 7.
template <class T>
T mvs_cross_density(const Curvature<T>& k, const PrincipalAngle<T>& angle, const T& scale, Curvature<T>& adjoint) {
  const T h1 = 0.5 * (k.c[0] + k.c[2]), h2 = 0.5 * (k.c[1] + k.c[3]);
  const T a1 = 0.5 * (k.c[0] - k.c[2]), a2 = 0.5 * (k.c[1] - k.c[3]);
  const T d1 = angle.cosine * a1 + angle.sine * k.c[1], d2 = angle.cosine * a2 + angle.sine * k.c[2];

  const T dh1 = 4.0 * scale * h1, dh2 = 4.0 * scale * h2, dd1 = 4.0 * scale * d1, dd2 = 4.0 * scale * d2;
  adjoint.c[0] += 0.5 * (dh1 + angle.cosine * dd1);
  adjoint.c[1] += 0.5 * (dh2 + angle.cosine * dd2) + angle.sine * dd1;
  adjoint.c[2] += 0.5 * (dh1 - angle.cosine * dd1) + angle.sine * dd2;
  adjoint.c[3] += 0.5 * (dh2 - angle.cosine * dd2);
  angle.pull_back(k, a1 * dd1 + a2 * dd2, k.c[1] * dd1 + k.c[2] * dd2, adjoint);
  return 2.0 * (h1 * h1 + h2 * h2 + d1 * d1 + d2 * d2);
}

/// Mean over all directions of the squared derivative of the normal curvature, in 1/length^4. Mehlum & Tarrou 1998.
template <class T>
T mehlum_tarrou_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  const T eighth = 0.125 * scale;
  const T g0 = 5.0 * k.c[0] + 3.0 * k.c[2], g1 = 9.0 * k.c[1] + 3.0 * k.c[3];
  const T g2 = 9.0 * k.c[2] + 3.0 * k.c[0], g3 = 5.0 * k.c[3] + 3.0 * k.c[1];
  adjoint.c[0] += eighth * g0;
  adjoint.c[1] += eighth * g1;
  adjoint.c[2] += eighth * g2;
  adjoint.c[3] += eighth * g3;
  return 0.0625 * (k.c[0] * g0 + k.c[1] * g1 + k.c[2] * g2 + k.c[3] * g3);
}

/// |grad II|^2, in 1/length^4.
template <class T>
T second_form_variation_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  adjoint.c[0] += 2.0 * scale * k.c[0];
  adjoint.c[1] += 6.0 * scale * k.c[1];
  adjoint.c[2] += 6.0 * scale * k.c[2];
  adjoint.c[3] += 2.0 * scale * k.c[3];
  return k.c[0] * k.c[0] + k.c[3] * k.c[3] + 3.0 * (k.c[1] * k.c[1] + k.c[2] * k.c[2]);
}

/// |T|^2 with T_i = C_ikk, that is 4 |grad H|^2, in 1/length^4: 0 where the mean curvature is constant.
template <class T>
T mean_curvature_variation_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  const T t1 = k.c[0] + k.c[2], t2 = k.c[1] + k.c[3];
  const T d1 = 2.0 * scale * t1, d2 = 2.0 * scale * t2;
  adjoint.c[0] += d1;
  adjoint.c[1] += d2;
  adjoint.c[2] += d1;
  adjoint.c[3] += d2;
  return t1 * t1 + t2 * t2;
}

/// |v|^2 with v_k = II_ij C_ijk, that is the squared gradient of the squared curvedness (kappa1^2 + kappa2^2)/2, in
/// 1/length^6: 0 where |II| is constant. Koenderink & van Doorn 1992, Surface shape and curvature scales, for the
/// curvedness.
template <class T>
T curvedness_variation_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  const T twice_q = 2.0 * k.q;
  const T v1 = k.p * k.c[0] + twice_q * k.c[1] + k.r * k.c[2], v2 = k.p * k.c[1] + twice_q * k.c[2] + k.r * k.c[3];
  const T d1 = 2.0 * scale * v1, d2 = 2.0 * scale * v2;
  adjoint.p += d1 * k.c[0] + d2 * k.c[1];
  adjoint.q += 2.0 * (d1 * k.c[1] + d2 * k.c[2]);
  adjoint.r += d1 * k.c[2] + d2 * k.c[3];
  adjoint.c[0] += d1 * k.p;
  adjoint.c[1] += d1 * twice_q + d2 * k.p;
  adjoint.c[2] += d1 * k.r + d2 * twice_q;
  adjoint.c[3] += d2 * k.r;
  return v1 * v1 + v2 * v2;
}

/// |Gamma|^2, in 1/length^2, with Gamma the Christoffel symbols of the patch's parameters in an orthonormal frame. 0 if
/// and only if the parameters are affine in geodesic ones, so it grows where patches are stretched or uneven. It does
/// not depend on the surface's size or on affine changes of the parameters.
template <class T>
T parametrization_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  T sum{};
  for (int m = 0; m < 2; ++m) {
    for (int i = 0; i < 3; ++i) {
      const double count = i == 1 ? 2.0 : 1.0;  // of Gamma_12 and Gamma_21
      sum += count * (k.christoffel[m][i] * k.christoffel[m][i]);
      adjoint.christoffel[m][i] += 2.0 * count * (scale * k.christoffel[m][i]);
    }
  }
  return sum;
}

/// Weighted sum of the densities whose functionals have the factor area^kPower; `weights` in the order of `Functional`.
template <int kPower, class T>
T weighted_density(const double* weights, const Curvature<T>& k, const T& scale, Curvature<T>& adjoint,
                   double umbilic_eta = kUmbilicEta) {
  T sum{};
  if constexpr (kPower == 0) {
    if (weights[kBending] != 0) sum += weights[kBending] * bending_density(k, scale * weights[kBending], adjoint);
    if (weights[kWillmore] != 0) sum += weights[kWillmore] * willmore_density(k, scale * weights[kWillmore], adjoint);
  } else if constexpr (kPower == 1) {
    if (weights[kMvs] != 0 || weights[kMvsCross] != 0) {
      const PrincipalAngle<T> angle(k, umbilic_eta);
      if (weights[kMvs] != 0) sum += weights[kMvs] * mvs_density(k, angle, scale * weights[kMvs], adjoint);
      if (weights[kMvsCross] != 0) {
        sum += weights[kMvsCross] * mvs_cross_density(k, angle, scale * weights[kMvsCross], adjoint);
      }
    }
    if (weights[kMehlumTarrou] != 0) {
      sum += weights[kMehlumTarrou] * mehlum_tarrou_density(k, scale * weights[kMehlumTarrou], adjoint);
    }
    if (weights[kSecondFormVariation] != 0) {
      const double w = weights[kSecondFormVariation];
      sum += w * second_form_variation_density(k, scale * w, adjoint);
    }
    if (weights[kMeanCurvatureVariation] != 0) {
      const double w = weights[kMeanCurvatureVariation];
      sum += w * mean_curvature_variation_density(k, scale * w, adjoint);
    }
  } else if (weights[kCurvednessVariation] != 0) {
    const double w = weights[kCurvednessVariation];
    sum += w * curvedness_variation_density(k, scale * w, adjoint);
  }
  return sum;
}

/// That of all third-order densities, for weights that contain their powers of the area.
template <class T>
T third_order_density(const double* weights, const Curvature<T>& k, const T& scale, Curvature<T>& adjoint,
                      double umbilic_eta = kUmbilicEta) {
  static_assert(kAreaPowerCount == 3);
  return weighted_density<1>(weights, k, scale, adjoint, umbilic_eta) + weighted_density<2>(weights, k, scale, adjoint);
}

}  // namespace umbilic::UMBILIC_KERNELS
