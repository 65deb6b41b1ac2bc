// SPDX-License-Identifier: MIT
/// \file
/// Covariant derivatives of a scalar function on the surface, as linear functions of its parametric derivatives.
#pragma once

#include "base/types.h"
#include "surface/derivatives.h"

namespace umbilic {

/// Columns: the function's derivatives f_u, f_v, f_uu, …, f_vvv. Rows, such that the sum of their squares is the
/// tensor's norm: three for the Hessian (11, 12 with factor sqrt 2, 22) or six for its derivative (the same three by e1
/// and by e2).
using SecondCovariant = Eigen::Matrix<double, 3, kThirdOrderCount>;
using ThirdCovariant = Eigen::Matrix<double, 6, kThirdOrderCount>;

/// `jet` holds the surface's derivatives of order 1 to 3, a row each.
struct CovariantDerivatives {
  SecondCovariant second;
  ThirdCovariant third;
  double area;  ///< |X_u x X_v|

  /// `third` is left out unless it is wanted.
  explicit CovariantDerivatives(const Eigen::Matrix<double, kThirdOrderCount, 3>& jet, bool with_third = true);
};

}  // namespace umbilic
