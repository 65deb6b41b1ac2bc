// SPDX-License-Identifier: MIT
/// \file
/// Uniform bicubic B-splines over a 4 x 4 grid of control points.
#pragma once

#include <array>

#include "base/types.h"
#include "opinion/taylor.h"

namespace umbilic::opinion {

/// A derivative at x of the cardinal B-spline with support [0, degree + 1], from the recursion B_i^d = ((x - i)
/// B_i^(d-1) + (i + d + 1 - x) B_(i+1)^(d-1)) / d and d/dx B_i^d = B_i^(d-1) - B_(i+1)^(d-1).
inline double cardinal_bspline(int degree, double x, int derivative) {
  if (derivative > 0) {
    return cardinal_bspline(degree - 1, x, derivative - 1) - cardinal_bspline(degree - 1, x - 1, derivative - 1);
  }
  if (degree == 0) return x >= 0 && x < 1 ? 1 : 0;
  return (x * cardinal_bspline(degree - 1, x, 0) + (degree + 1 - x) * cardinal_bspline(degree - 1, x - 1, 0)) / degree;
}

/// At s in [0, 1]: entry (k, i) is the coefficient of the k-th power in the i-th of the four B-splines that are not 0.
inline Eigen::Matrix4d bspline_coefficients(double s) {
  constexpr double kFactorial[] = {1, 1, 2, 6};
  // The recursion's pieces are half open. In [0, 1] the i-th one is that of [3 - i, 4 - i], to its end by a point
  // within it and the polynomial's Taylor series, which is exact.
  Eigen::Matrix4d b;
  constexpr double kWithin = 0.5;
  const double d = s - kWithin;
  for (int i = 0; i < 4; ++i) {
    double c[4];
    for (int k = 0; k < 4; ++k) c[k] = cardinal_bspline(3, 3 - i + kWithin, k) / kFactorial[k];
    b(0, i) = c[0] + d * (c[1] + d * (c[2] + d * c[3]));
    b(1, i) = c[1] + d * (2 * c[2] + d * 3 * c[3]);
    b(2, i) = c[2] + d * 3 * c[3];
    b(3, i) = c[3];
  }
  return b;
}

/// Control points (a, b) at 4 b + a, those of the unit square being (1, 1), (2, 1), (2, 2), (1, 2).
using Grid = Eigen::Matrix<double, 16, 3, Eigen::RowMajor>;

/// The spline near (s, t), from the coefficients at s and at t.
inline TaylorPoint bicubic(const Grid& grid, const Eigen::Matrix4d& along_s, const Eigen::Matrix4d& along_t) {
  TaylorPoint point;
  for (int l = 0; l < 4; ++l) {
    Eigen::Matrix<double, 4, 3> row;
    for (int a = 0; a < 4; ++a) {
      row.row(a) = along_t(l, 0) * grid.row(a) + along_t(l, 1) * grid.row(4 + a) + along_t(l, 2) * grid.row(8 + a) +
                   along_t(l, 3) * grid.row(12 + a);
    }
    for (int k = 0; k + l < 4; ++k) {
      const Eigen::RowVector3d c = along_s.row(k) * row;
      for (int x = 0; x < 3; ++x) point[x].c[Taylor::index(k, l)] = c[x];
    }
  }
  return point;
}

}  // namespace umbilic::opinion
