// SPDX-License-Identifier: MIT
/// \file
/// The four uniform cubic B-splines of one knot interval.
#pragma once

#include <Eigen/Core>

namespace umbilic {

/// Row k holds the k-th derivative of the four basis functions at t in [0, 1].
inline Eigen::Matrix4d cubic_bspline(double t) {
  const double s = 1 - t;
  Eigen::Matrix4d b;
  b << s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6,  //
      -s * s / 2, (3 * t * t - 4 * t) / 2, (4 * s - 3 * s * s) / 2, t * t / 2,                                  //
      s, 3 * t - 2, 3 * s - 2, t,                                                                               //
      -1, 3, -3, 1;
  return b;
}

}  // namespace umbilic
