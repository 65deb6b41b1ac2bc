// SPDX-License-Identifier: MIT
/// \file
/// Whether the samples of a surface see all of its curvature. By Gauss & Bonnet's theorem the integral of K is 2 pi
/// chi. If the computed integral differs, the samples miss some curvature, as in folds or in the necks of a surface
/// that falls apart, and the computed energies are not those of the surface.
#pragma once

#include <numbers>

namespace umbilic {

/// Largest error of the integral of the Gaussian curvature. Missing the smallest neck would be an error of 4 pi.
inline constexpr double kLargestDefect = 0.5;

/// |integral of K - 2 pi chi|.
constexpr double gauss_bonnet_defect(double gaussian, int euler_characteristic) {
  const double difference = gaussian - 2 * std::numbers::pi * euler_characteristic;
  return difference < 0 ? -difference : difference;
}

}  // namespace umbilic
