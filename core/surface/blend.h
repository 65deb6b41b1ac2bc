// SPDX-License-Identifier: MIT
/// \file
/// The functions that blend a cap into the limit surface: 1 at the extraordinary vertex, 0 at the rim.
#pragma once

#include "surface/derivatives.h"

namespace umbilic {

/// Derivatives of order 0 to 3.
using Derivatives1 = Eigen::Vector4d;

/// Joshi & Sequin eq. 8: h(t) / (h(t) + h(1 - t)) with h(t) = exp(2 exp(-1/t) / (t - 1)). All its derivatives vanish at
/// t = 0 and 1.
Derivatives1 paper_blend(double t);

/// 1 - (35 t^4 - 84 t^5 + 70 t^6 - 20 t^7); its derivatives of order 1 to 3 vanish at t = 0 and 1.
Derivatives1 smoothstep_blend(double t);

/// Derivatives of f(u / scale) f(v / scale).
Derivatives tensor_blend(Derivatives1 (*f)(double), double u, double v, double scale);

}  // namespace umbilic
