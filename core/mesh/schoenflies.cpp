// SPDX-License-Identifier: MIT
/// \file
/// Derives the symbol from the axes, their orders and the mirrors.
#include "mesh/schoenflies.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/symmetric_eigen.h"

namespace umbilic {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Axes are parallel if the sine of their angle is smaller. Except in Cn and Dn, different axes are 20 degrees apart.
constexpr double kParallel = 1e-6;

/// The rotation's angle in [0, pi], accurate for all angles.
double angle_of(const Matrix3d& rotation) {
  const Vector3d twice_sine(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                            rotation(1, 0) - rotation(0, 1));
  return std::atan2(twice_sine.norm(), rotation.trace() - 1);
}

/// The unit vector v with m v = v. `m` is a rotation other than the identity, or minus a mirror; then v is its normal.
Vector3d axis_of(const Matrix3d& m) { return symmetric_eigen(m + m.transpose()).vectors.col(2); }

bool parallel(const Vector3d& a, const Vector3d& b) { return a.cross(b).norm() < kParallel; }

/// What the symbol needs to know of the rotations in the group.
struct Rotations {
  int order = 1;
  bool one_axis = true;
  double smallest_angle = 4;    // 4 > pi while there is no rotation
  Vector3d principal{0, 0, 0};  // axis of the smallest angle

  void add(const Matrix3d& rotation) {
    const double angle = angle_of(rotation);
    if (angle < kParallel) return;
    ++order;
    const Vector3d axis = axis_of(rotation);
    one_axis = one_axis && (smallest_angle > 3.5 || parallel(axis, principal));
    if (angle > smallest_angle - kParallel) return;
    smallest_angle = angle;
    principal = axis;
  }
  /// Largest order of an axis.
  int fold() const { return static_cast<int>(std::lround(2 * std::numbers::pi / smallest_angle)); }
};

}  // namespace

std::string schoenflies_symbol(const std::vector<Matrix3d>& elements) {
  Rotations rotations;
  for (const Matrix3d& m : elements) {
    if (m.determinant() > 0) rotations.add(m);
  }
  const bool proper = rotations.order == static_cast<int>(elements.size());
  bool inversion = false, horizontal = false, mirror = false;
  for (const Matrix3d& m : elements) {
    if (m.determinant() > 0) continue;
    const double angle = angle_of(-m);  // minus a mirror is a half turn
    inversion = inversion || angle < kParallel;
    if (angle < std::numbers::pi - kParallel) continue;
    mirror = true;
    horizontal = horizontal || rotations.order == 1 || parallel(axis_of(-m), rotations.principal);
  }

  const int fold = rotations.order == 1 ? 1 : rotations.fold();
  if (rotations.one_axis) {
    if (proper) return fmt::format("C{}", rotations.order);
    if (rotations.order == 1) return mirror ? "Cs" : "Ci";
    if (horizontal) return fmt::format("C{}h", rotations.order);
    return mirror ? fmt::format("C{}v", rotations.order) : fmt::format("S{}", 2 * rotations.order);
  }
  if (rotations.order != 2 * fold) {
    const char* const symbol = fold == 3 ? "T" : fold == 4 ? "O" : "I";
    if (proper) return symbol;
    return fmt::format("{}{}", symbol, fold == 3 && !inversion ? "d" : "h");
  }
  if (proper) return fmt::format("D{}", fold);
  // The three axes of D2 are equivalent, so some mirror is horizontal to one of them in any case; only D2h has the
  // inversion.
  return fmt::format("D{}{}", fold, (fold == 2 ? inversion : horizontal) ? "h" : "d");
}

}  // namespace umbilic
