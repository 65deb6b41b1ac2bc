// SPDX-License-Identifier: MIT
/// \file
/// Differentiates the normal of a surface twice.
#include "opinion/integrands.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace umbilic::opinion {
namespace {

using Vector = Eigen::Vector3d;

/// The derivative (k, l) of a point.
Vector derivative(const TaylorPoint& x, int k, int l) {
  return {x[0].derivative(k, l), x[1].derivative(k, l), x[2].derivative(k, l)};
}

TaylorPoint by_s(const TaylorPoint& x) { return {x[0].by_s(), x[1].by_s(), x[2].by_s()}; }
TaylorPoint by_t(const TaylorPoint& x) { return {x[0].by_t(), x[1].by_t(), x[2].by_t()}; }

double square(double x) { return x * x; }

/// The mean of C(d, d, d)^2 over the unit vectors d. As a function of the angle it has no frequency above 6, so that
/// the mean over eight directions is exact.
double mean_square_slope(const Eigen::Matrix2d (&c)[2]) {
  constexpr int kDirections = 8;
  double sum = 0;
  for (int m = 0; m < kDirections; ++m) {
    const double angle = 2 * std::numbers::pi * m / kDirections;
    const Eigen::Vector2d d(std::cos(angle), std::sin(angle));
    sum += square(d.dot((d[0] * c[0] + d[1] * c[1]) * d));
  }
  return sum / kDirections;
}

}  // namespace

Quantities integrands(const TaylorPoint& x) {
  const TaylorPoint xs = by_s(x), xt = by_t(x), w = cross(xs, xt);
  const Taylor inverse = pow(dot(w, w), -0.5);
  const TaylorPoint n = w * inverse, dual_s = cross(xt, n) * inverse, dual_t = cross(n, xs) * inverse;
  const double element = 1 / inverse.c[0];

  const Vector ns = derivative(n, 1, 0), nt = derivative(n, 0, 1), nst = derivative(n, 1, 1);
  const Vector along_s = derivative(dual_s, 0, 0), along_t = derivative(dual_t, 0, 0);
  const Eigen::Matrix3d b = ns * along_s.transpose() + nt * along_t.transpose();
  const Eigen::Matrix3d b_s = derivative(n, 2, 0) * along_s.transpose() + ns * derivative(dual_s, 1, 0).transpose() +
                              nst * along_t.transpose() + nt * derivative(dual_t, 1, 0).transpose();
  const Eigen::Matrix3d b_t = nst * along_s.transpose() + ns * derivative(dual_s, 0, 1).transpose() +
                              derivative(n, 0, 2) * along_t.transpose() + nt * derivative(dual_t, 0, 1).transpose();

  // The eigenvectors, first in any orthonormal frame of the tangent plane.
  Eigen::Matrix<double, 3, 2> e;
  e.col(0) = derivative(xs, 0, 0).normalized();
  e.col(1) = derivative(n, 0, 0).cross(e.col(0));
  const Eigen::Matrix2d frame = e.transpose() * b * e;
  const double angle = 0.5 * std::atan2(frame(0, 1) + frame(1, 0), frame(0, 0) - frame(1, 1));
  e = (e * Eigen::Rotation2Dd(angle).toRotationMatrix()).eval();
  const Eigen::Vector2d kappa = (e.transpose() * b * e).diagonal();
  Eigen::Matrix2d c[2];  // the derivative of B along e_k
  for (int k = 0; k < 2; ++k) {
    c[k] = e.transpose() * (e.col(k).dot(along_s) * b_s + e.col(k).dot(along_t) * b_t) * e;
  }

  const double second = kappa.squaredNorm();
  double mvs_cross = 0, form = 0, mean = 0, curvedness = 0, gradient_form = 0, variation_form = 0, triple_form = 0;
  for (int k = 0; k < 2; ++k) {
    mvs_cross += c[k].diagonal().squaredNorm();
    form += c[k].squaredNorm();
    mean += square(c[k].trace());
    curvedness += square(kappa.dot(c[k].diagonal()));
    gradient_form += kappa[k] * square(c[k].trace());
    variation_form += (kappa.asDiagonal() * c[k].cwiseAbs2()).sum();
    triple_form += kappa[k] * kappa.dot(c[k].cwiseAbs2() * kappa);
  }
  Quantities values{1,
                    kappa[0] * kappa[1],
                    second,
                    square(kappa.sum() / 2),
                    square(c[0](0, 0)) + square(c[1](1, 1)),
                    mvs_cross,
                    mean_square_slope(c),
                    form,
                    mean,
                    curvedness,
                    gradient_form,
                    variation_form,
                    triple_form};
  for (double& value : values) value *= element;
  return values;
}

}  // namespace umbilic::opinion
