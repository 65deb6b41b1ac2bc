// SPDX-License-Identifier: MIT
/// \file
/// The array types that every layer shares.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace umbilic {

/// Control points or positions, one row (x, y, z) each.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

using Vector3 = Eigen::Vector3d;

}  // namespace umbilic
