// SPDX-License-Identifier: MIT
/// \file
/// The Schoenflies symbol of a finite group of orthogonal matrices.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace umbilic {

/// `elements` lists each element of the group once, orthogonal to about 1e-9. Every finite subgroup of O(3) has a
/// symbol.
std::string schoenflies_symbol(const std::vector<Eigen::Matrix3d>& elements);

}  // namespace umbilic
