// SPDX-License-Identifier: MIT
/// \file
/// The array types that every layer shares.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

// The package of the library says how it was compiled. With AVX, Eigen aligns and frees its arrays in another way, and
// programs that mix both crash.
#if defined(UMBILIC_BUILT_WITH_AVX) && UMBILIC_BUILT_WITH_AVX != defined(__AVX__)
#error "Compile with AVX exactly if umbilic was (see -mavx, -march): otherwise Eigen's arrays cannot be passed to it"
#endif

namespace umbilic {

/// Control points or positions, one row (x, y, z) each.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

using Vector3 = Eigen::Vector3d;

}  // namespace umbilic
