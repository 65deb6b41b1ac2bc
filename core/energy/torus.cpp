// SPDX-License-Identifier: MIT
/// \file
/// Closed forms, and bisection for the only sign change of the derivative.
#include "energy/torus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace umbilic {
namespace {

constexpr double kPi2 = std::numbers::pi * std::numbers::pi;
constexpr double kCliffordRatio = std::numbers::sqrt2 / 2;
constexpr double kWillmoreOfBending = 1.0 / 4;
constexpr double kMehlumTarrouOfCross = 9.0 / 16;
constexpr double kSecondFormOfCross = 3;
constexpr double kMeanCurvatureOfCross = 1;

double bending(double a) { return 4 * kPi2 / (a * std::sqrt((1 - a) * (1 + a))); }
double mvs_cross(double a) { return 8 * kPi2 * kPi2 * std::pow((1 - a) * (1 + a), -1.5); }
double curvedness(double a) { return 8 * kPi2 * kPi2 * kPi2 * a * (1 + 4 * a * a) * std::pow((1 - a) * (1 + a), -3.5); }

}  // namespace

std::array<double, kFunctionalCount> torus_energies(double ratio) {
  const double second = bending(ratio), third = mvs_cross(ratio);
  std::array<double, kFunctionalCount> energies{};
  energies[kBending] = second;
  energies[kWillmore] = kWillmoreOfBending * second;
  energies[kMvs] = 0;
  energies[kMvsCross] = third;
  energies[kMehlumTarrou] = kMehlumTarrouOfCross * third;
  energies[kSecondFormVariation] = kSecondFormOfCross * third;
  energies[kMeanCurvatureVariation] = kMeanCurvatureOfCross * third;
  energies[kCurvednessVariation] = curvedness(ratio);
  return energies;
}

TorusMinimizer torus_minimizer(const Weights& weights) {
  // The energy is w1 bending(a) + w2 mvs_cross(a) + w3 curvedness(a).
  const double w1 = weights[kBending] + kWillmoreOfBending * weights[kWillmore];
  const double w2 = weights[kMvsCross] + kMehlumTarrouOfCross * weights[kMehlumTarrou] +
                    kSecondFormOfCross * weights[kSecondFormVariation] +
                    kMeanCurvatureOfCross * weights[kMeanCurvatureVariation];
  const double w3 = weights[kCurvednessVariation];
  if (w1 == 0 && w2 == 0 && w3 == 0) return {std::numeric_limits<double>::quiet_NaN(), 0, true};
  if (w1 == 0) return {0, w2 * mvs_cross(0), false};

  // The derivative has the sign of 6 pi^2 w2 a^3 + 2 pi^4 w3 a^2 (1 + 18 a^2 + 16 a^4)/(1 - a^2)^2 - w1 (1 - a^2)(1 - 2
  // a^2), which rises from -w1 at 0 to >= 0 at the Clifford torus.
  const double scale = std::max({w1, w2, w3});
  const auto rises = [&](double a) {
    const double b = a * a, of_curvedness = 2 * kPi2 * kPi2 * b * (1 + 18 * b + 16 * b * b) / ((1 - b) * (1 - b));
    return 6 * kPi2 * (w2 / scale) * a * a * a + of_curvedness * (w3 / scale) >= (w1 / scale) * (1 - b) * (1 - 2 * b);
  };
  double low = 0, high = kCliffordRatio;
  for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2) {
    (rises(middle) ? high : low) = middle;
  }
  return {high, w1 * bending(high) + w2 * mvs_cross(high) + w3 * curvedness(high), true};
}

}  // namespace umbilic
