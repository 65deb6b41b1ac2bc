// SPDX-License-Identifier: MIT
/// \file
/// Velocities of similarities and special conformal maps at given points.
#include "optimize/gauge.h"

namespace umbilic {

Points scaling_direction(const Points& control) { return control.rowwise() - control.colwise().mean(); }

Eigen::MatrixXd gauge_directions(const Gauge& gauge, const Points& control) {
  const Points x = scaling_direction(control);
  const double size = x.rowwise().norm().maxCoeff();
  Eigen::MatrixXd directions(x.size(), gauge.dimension());
  for (Eigen::Index v = 0; v < x.rows(); ++v) {
    const Vector3 p = x.row(v).transpose() / size;
    auto rows = directions.middleRows<3>(3 * v);
    int column = 0;
    for (int i = 0; i < 3 && gauge.translations; ++i) rows.col(column++) = Vector3::Unit(i);
    for (int i = 0; i < 3 && gauge.rotations; ++i) rows.col(column++) = Vector3::Unit(i).cross(p);
    if (gauge.scaling) rows.col(column++) = p;
    for (int i = 0; i < 3 && gauge.conformal; ++i) {
      rows.col(column++) = p.squaredNorm() * Vector3::Unit(i) - 2 * p[i] * p;
    }
  }
  return directions;
}

/// Gram and Schmidt's process, each column twice: once leaves too much of the others where the points are nearly flat.
void orthonormalize(Eigen::MatrixXd& q) {
  for (Eigen::Index i = 0; i < q.cols(); ++i) {
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index j = 0; j < i; ++j) q.col(i) -= q.col(j).dot(q.col(i)) * q.col(j);
    }
    q.col(i).normalize();
  }
}

Eigen::MatrixXd orthonormal_gauge(const Gauge& gauge, const Points& control) {
  Eigen::MatrixXd q = gauge_directions(gauge, control);
  orthonormalize(q);
  return q;
}

}  // namespace umbilic
