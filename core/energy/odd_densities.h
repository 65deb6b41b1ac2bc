// SPDX-License-Identifier: MIT
/// \file
/// The integrands of the invariants that are only evaluated (invariants.h), as functions of II = (p, q, r) and C = (c0,
/// …, c3). They are not minimized and have no gradients.
#pragma once

#include "energy/curvature.h"

namespace umbilic::UMBILIC_KERNELS {

/// II(T, T) with T_i = C_ikk = 2 grad H, in 1/length^5.
template <class T>
T gradient_form_density(const Curvature<T>& k) {
  const T t1 = k.c[0] + k.c[2], t2 = k.c[1] + k.c[3];
  return k.p * t1 * t1 + 2.0 * k.q * t1 * t2 + k.r * t2 * t2;
}

/// II_ij C_ikl C_jkl, in 1/length^5.
template <class T>
T variation_form_density(const Curvature<T>& k) {
  const T(&c)[4] = k.c;
  const T square1 = c[0] * c[0] + 2.0 * c[1] * c[1] + c[2] * c[2];
  const T square2 = c[1] * c[1] + 2.0 * c[2] * c[2] + c[3] * c[3];
  const T product = c[0] * c[1] + 2.0 * c[1] * c[2] + c[2] * c[3];
  return k.p * square1 + 2.0 * k.q * product + k.r * square2;
}

/// II_ia II_jb II_kc C_ijk C_abc, in 1/length^7: the product of C with what II makes of it, index by index.
template <class T>
T triple_form_density(const Curvature<T>& k) {
  const T &p = k.p, &q = k.q, &r = k.r;
  T along1[3], along2[3];  // one index mapped, to 1 or 2; the others as in C
  for (int n = 0; n < 3; ++n) {
    along1[n] = p * k.c[n] + q * k.c[n + 1];
    along2[n] = q * k.c[n] + r * k.c[n + 1];
  }
  T along11[2], along12[2], along22[2];
  for (int n = 0; n < 2; ++n) {
    along11[n] = p * along1[n] + q * along1[n + 1];
    along12[n] = q * along1[n] + r * along1[n + 1];
    along22[n] = q * along2[n] + r * along2[n + 1];
  }
  return k.c[0] * (p * along11[0] + q * along11[1]) + 3.0 * k.c[1] * (q * along11[0] + r * along11[1]) +
         3.0 * k.c[2] * (q * along12[0] + r * along12[1]) + k.c[3] * (q * along22[0] + r * along22[1]);
}

}  // namespace umbilic::UMBILIC_KERNELS
