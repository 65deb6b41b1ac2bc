// SPDX-License-Identifier: MIT
/// \file
/// Scaling by powers of two, which rounds nothing.
#include "cage/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbilic {
namespace {

/// Of unit coordinates about the origin.
constexpr double kLargestCentred = 8;

/// x + by, but -0 stays what it is where nothing is added.
double moved(double x, double by) { return by == 0 ? x : x + by; }

}  // namespace

Points Placement::to_unit(const Points& points) const {
  Points unit(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) unit.row(i) = to_unit(Vector3(points.row(i))).transpose();
  return unit;
}

Points Placement::back(const Points& points) const {
  Points original(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) original.row(i) = back(Vector3(points.row(i))).transpose();
  return original;
}

Vector3 Placement::to_unit(const Vector3& point) const {
  Vector3 unit;
  for (int axis = 0; axis < 3; ++axis) {
    unit[axis] = moved(std::ldexp(point[axis], -exponent), -std::ldexp(centre[axis], -exponent));
  }
  return unit;
}

Vector3 Placement::back(const Vector3& point) const {
  Vector3 original;
  for (int axis = 0; axis < 3; ++axis) {
    original[axis] = std::ldexp(moved(point[axis], std::ldexp(centre[axis], -exponent)), exponent);
  }
  return original;
}

Points Placement::rounding(const Points& points) const {
  constexpr int kBelow = std::numeric_limits<double>::digits;  // half a unit in the last place of 1 is 2^-53
  return points.unaryExpr([&](double x) { return x == 0 ? 0 : std::ldexp(1., std::ilogb(x) - kBelow - exponent); });
}

Placement placement_of(const Points& points) {
  if (points.rows() == 0) return {};
  return placement_of(Vector3(points.colwise().minCoeff()), Vector3(points.colwise().maxCoeff()));
}

Placement placement_of(const Vector3& low, const Vector3& high) {
  const double half = (high / 2 - low / 2).maxCoeff();  // halved first: the whole may overflow
  if (!(half > 0)) return {};
  Placement placement;
  placement.exponent = std::ilogb(half);
  const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  if (std::ldexp(largest, -placement.exponent) < kLargestCentred) return placement;
  const int quarter = placement.exponent - 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = low[axis] / 2 + high[axis] / 2;
    placement.centre[axis] = std::ldexp(std::round(std::ldexp(middle, -quarter)), quarter);
  }
  return placement;
}

}  // namespace umbilic
