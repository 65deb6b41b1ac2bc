// SPDX-License-Identifier: MIT
/// \file
/// Principal axes by the eigenvectors of the points' covariance.
#include "driver/thickness.h"

#include <algorithm>
#include <vector>

#include "base/symmetric_eigen.h"

namespace umbilic {
namespace {

/// Standard deviations, relative to the largest, that rounding may have left of none: the square root of what it leaves
/// of their squares.
constexpr double kNoThickness = 1e-7;

/// The map that stretches what has this covariance.
Eigen::Matrix3d stretch(const Eigen::Matrix3d& covariance, double ratio) {
  const SymmetricEigen axes = symmetric_eigen(covariance);
  const Eigen::Vector3d deviations = axes.values.cwiseMax(0).cwiseSqrt();  // rising
  const double largest = deviations[2];
  if (!(deviations[0] > kNoThickness * largest)) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d factors = deviations.cwiseMax(largest / ratio).cwiseQuotient(deviations);
  return axes.vectors * factors.asDiagonal() * axes.vectors.transpose();
}

}  // namespace

Points thickened(const Points& control, const MeshComponents& components, double ratio) {
  const std::size_t count = components.genera.size();
  std::vector<Eigen::Vector3d> means(count, Eigen::Vector3d::Zero());
  std::vector<Eigen::Matrix3d> covariances(count, Eigen::Matrix3d::Zero());
  std::vector<int> sizes(count, 0);
  for (Eigen::Index v = 0; v < control.rows(); ++v) {
    means[components.of_vertex[v]] += control.row(v).transpose();
    ++sizes[components.of_vertex[v]];
  }
  for (std::size_t c = 0; c < count; ++c) means[c] /= sizes[c];
  for (Eigen::Index v = 0; v < control.rows(); ++v) {
    const Eigen::Vector3d offset = control.row(v).transpose() - means[components.of_vertex[v]];
    covariances[components.of_vertex[v]] += offset * offset.transpose();
  }
  std::vector<Eigen::Matrix3d> maps;
  for (const Eigen::Matrix3d& covariance : covariances) maps.push_back(stretch(covariance, ratio));
  Points result(control.rows(), 3);
  for (Eigen::Index v = 0; v < control.rows(); ++v) {
    const int c = components.of_vertex[v];
    result.row(v) = (means[c] + maps[c] * (control.row(v).transpose() - means[c])).transpose();
  }
  return result;
}

}  // namespace umbilic
