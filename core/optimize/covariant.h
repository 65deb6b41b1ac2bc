// SPDX-License-Identifier: MIT
/// \file
/// Covariant derivatives of a scalar function on the surface, as linear functions of its parametric derivatives.
#pragma once

#include "base/types.h"
#include "surface/derivatives.h"

namespace umbilic {

/// Columns: the derivatives f_u, f_v, f_uu, …, f_vvv of the function. Rows: components whose sum of squares is the
/// squared norm of the tensor. The Hessian has three (11, sqrt 2 times 12, 22); its derivative has six (the same by e1,
/// then by e2).
using SecondCovariant = Eigen::Matrix<double, 3, kThirdOrderCount>;
using ThirdCovariant = Eigen::Matrix<double, 6, kThirdOrderCount>;

/// `jet` holds the derivatives of order 1 to 3 of the surface, one per row.
struct CovariantDerivatives {
  SecondCovariant second;
  ThirdCovariant third;
  double area;  ///< |X_u x X_v|

  /// Computes `third` only if `with_third`.
  explicit CovariantDerivatives(const Eigen::Matrix<double, kThirdOrderCount, 3>& jet, bool with_third = true);
};

}  // namespace umbilic
