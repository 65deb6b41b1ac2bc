// SPDX-License-Identifier: MIT
/// \file
/// Whether the samples of a surface see all of its curvature: Gauss & Bonnet's theorem, the integral of K = 2 pi chi.
///
/// Where the integral is something else, curvature hides between the samples, as in folds or in the necks of a surface
/// that falls apart, and the energies are not the surface's.
#pragma once

#include <numbers>

namespace umbilic {

/// Of the integral of the Gaussian curvature; what hides in the smallest neck is 4 pi.
inline constexpr double kLargestDefect = 0.5;

/// |integral of K - 2 pi chi|.
constexpr double gauss_bonnet_defect(double gaussian, int euler_characteristic) {
  const double difference = gaussian - 2 * std::numbers::pi * euler_characteristic;
  return difference < 0 ? -difference : difference;
}

}  // namespace umbilic
