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

double bending(double a) { return 4 * kPi2 / (a * std::sqrt((1 - a) * (1 + a))); }
double mvs_cross(double a) { return 8 * kPi2 * kPi2 * std::pow((1 - a) * (1 + a), -1.5); }

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
  return energies;
}

TorusMinimizer torus_minimizer(const Weights& weights) {
  // The energy is w1 bending(a) + w2 mvs_cross(a).
  const double w1 = weights[kBending] + kWillmoreOfBending * weights[kWillmore];
  const double w2 = weights[kMvsCross] + kMehlumTarrouOfCross * weights[kMehlumTarrou] +
                    kSecondFormOfCross * weights[kSecondFormVariation];
  if (w1 == 0 && w2 == 0) return {std::numeric_limits<double>::quiet_NaN(), 0, true};
  if (w1 == 0) return {0, w2 * mvs_cross(0), false};

  // The derivative has the sign of 6 pi^2 w2 a^3 - w1 (1 - a^2)(1 - 2 a^2), which rises from -w1 at 0 to >= 0 at the
  // Clifford torus.
  const double scale = std::max(w1, w2);
  const auto rises = [&](double a) {
    return 6 * kPi2 * (w2 / scale) * a * a * a >= (w1 / scale) * (1 - a * a) * (1 - 2 * a * a);
  };
  double low = 0, high = kCliffordRatio;
  for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2) {
    (rises(middle) ? high : low) = middle;
  }
  return {high, w1 * bending(high) + w2 * mvs_cross(high), true};
}

}  // namespace umbilic
