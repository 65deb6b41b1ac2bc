// SPDX-License-Identifier: MIT
/// \file
/// Extrapolates, or refuses to.
#include "driver/extrapolate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbilic {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

LimitReport no_limit(LimitStatus status, double energy, double order) { return {status, energy, order, kNaN}; }

/// Of three levels: functionals of third order may fall slowly along surfaces that never settle.
bool settles(const LevelEnergy* levels) {
  const double before = std::abs(levels[1].bending - levels[0].bending);
  const double change = std::abs(levels[2].bending - levels[1].bending);
  return change <= std::max(kSettlingFraction * before, kSettledFraction * levels[2].bending);
}

}  // namespace

LimitReport extrapolate(const std::vector<LevelEnergy>& levels, bool third_order) {
  if (levels.empty()) return no_limit(LimitStatus::kTooFewLevels, kNaN, kNaN);
  const double last = levels.back().energy;
  if (!levels.back().whole) return no_limit(LimitStatus::kNotWhole, last, kNaN);
  if (levels.size() < 3) return no_limit(LimitStatus::kTooFewLevels, last, kNaN);
  const LevelEnergy* three = &levels[levels.size() - 3];
  const bool minimized = std::all_of(three, three + 3, [](const LevelEnergy& l) { return l.minimized; });
  const double before = three[0].energy - three[1].energy, decrease = three[1].energy - last;
  const double order = before > 0 && decrease > 0 ? std::log2(before / decrease) : kNaN;
  if (!minimized) return no_limit(LimitStatus::kNotMinimized, last, order);

  const double uncertainty = three[1].uncertainty + three[2].uncertainty;
  if (std::abs(decrease) <= uncertainty) {
    return {LimitStatus::kConverging, last, kNaN, std::abs(decrease) + uncertainty};
  }
  if (!(order >= kLeastOrder) || (third_order && !settles(three))) {
    return no_limit(LimitStatus::kNotConverging, last, order);
  }
  const double ratio = std::exp2(std::min(order, third_order ? 2.0 : 4.0));
  const double correction = decrease / (ratio - 1);
  return {LimitStatus::kConverging, last - correction, order,
          std::max(decrease - correction, correction) + uncertainty};
}

}  // namespace umbilic
