// SPDX-License-Identifier: MIT
/// \file
/// Extrapolates, or says why not.
#include "driver/extrapolate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbilic {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

LimitReport no_limit(LimitStatus status, double energy, double order) {
  return {status, energy, order, kNaN, kNaN, false};
}

/// The least of those that can be a surface's, or the last where none can.
double least_energy(const std::vector<LevelEnergy>& levels) {
  double least = kNaN;
  for (const LevelEnergy& level : levels) {
    if (level.resolved && !(level.energy >= least)) least = level.energy;
  }
  return std::isnan(least) ? levels.back().energy : least;
}

LimitReport limit_above(double bound, double energy, double order, double error, bool caps_included) {
  const double upper = energy + error;
  if (energy < bound) {
    energy = bound;
    error = std::max(upper - bound, 0.0);
  }
  return {LimitStatus::kConverging, energy, order, error, std::max(energy - error, bound), caps_included};
}

/// Whether the surfaces of three levels converge. Functionals of third order may decrease slowly along surfaces that
/// never do.
bool settles(const LevelEnergy* levels) {
  const double before = std::abs(levels[1].bending - levels[0].bending);
  const double change = std::abs(levels[2].bending - levels[1].bending);
  return change <= std::max(kSettlingFraction * before, kSettledFraction * levels[2].bending);
}

/// NaN if an energy has increased.
double observed_order(double before, double decrease) {
  return before > 0 && decrease > 0 ? std::log2(before / decrease) : kNaN;
}

/// Whether the last two orders were in the asymptotic range. A first order far above the elements' says that the first
/// of the levels was not.
bool converges_twice(const std::vector<LevelEnergy>& levels, double elements) {
  if (levels.size() < 4 || !levels[levels.size() - 4].minimized) return false;
  const LevelEnergy* last = &levels.back();
  const double first = last[-3].energy - last[-2].energy, before = last[-2].energy - last[-1].energy;
  const double earlier = observed_order(first, before);
  return earlier >= kLeastOrder && earlier <= elements + 1 &&
         observed_order(before, last[-1].energy - last[0].energy) >= kLeastOrder;
}

/// The least order that the last decrease is taken to go on with. `order` is the observed one, or NaN.
double least_order(const std::vector<LevelEnergy>& levels, double elements, double order) {
  const double least = converges_twice(levels, elements) ? kLeastOrder : 1;
  return std::isnan(order) ? least : std::max(least, elements - std::abs(order - elements) - 1);
}

/// The error that is left after the last of `levels`, if an earlier decrease was entirely due to the elements and falls
/// with their order.
double left_by_elements(const std::vector<LevelEnergy>& levels, double elements) {
  const LevelEnergy* last = &levels.back();
  const double before = last[-2].energy - last[-1].energy, decrease = last[-1].energy - last[0].energy;
  double expected = std::max(before, 0.0) / std::exp2(elements);
  if (levels.size() > 3 && last[-3].minimized) {
    const double first = last[-3].energy - last[-2].energy;
    const bool falls = 2 * observed_order(before, decrease) < observed_order(first, before);
    if (falls) expected = first / std::exp2(2 * elements);
  }
  return expected / (std::exp2(elements) - 1);
}

}  // namespace

LimitReport extrapolate(const std::vector<LevelEnergy>& levels, bool third_order, double lower_bound) {
  if (levels.empty()) return no_limit(LimitStatus::kTooFewLevels, kNaN, kNaN);
  const double last = levels.back().energy, least = least_energy(levels);
  if (!levels.back().resolved) return no_limit(LimitStatus::kNotResolved, least, kNaN);
  if (levels.size() < 3) return no_limit(LimitStatus::kTooFewLevels, least, kNaN);
  const LevelEnergy* three = &levels[levels.size() - 3];
  const bool minimized = std::all_of(three, three + 3, [](const LevelEnergy& l) { return l.minimized; });
  const double before = three[0].energy - three[1].energy, decrease = three[1].energy - last;
  double order = observed_order(before, decrease);
  if (!minimized) return no_limit(LimitStatus::kNotMinimized, least, order);

  const double uncertainty = three[1].uncertainty + three[2].uncertainty;
  const bool agree = std::abs(decrease) <= uncertainty;
  if (agree) {
    order = kNaN;
  } else if (!(order >= kLeastOrder) || (third_order && !settles(three))) {
    return no_limit(LimitStatus::kNotConverging, least, order);
  }
  const double elements = third_order ? 2 : 4;
  double correction = left_by_elements(levels, elements);
  if (std::abs(decrease) >= 2 * correction) {
    correction = agree ? 0 : decrease / (std::exp2(std::min(order, elements)) - 1);
  }
  const double most = std::abs(decrease) / (std::exp2(least_order(levels, elements, order)) - 1);
  double error = std::max(most - correction, correction) + uncertainty;
  bool caps_included = !third_order || three[2].cap_rings == 0 || three[2].cap_rings > three[1].cap_rings;
  if (!caps_included && std::isfinite(three[1].with_narrower_caps)) {
    const double half = (three[1].with_narrower_caps - three[1].energy) / 2;
    correction += half;
    error += std::abs(half);
    caps_included = true;
  }
  return limit_above(lower_bound, last - correction, order, error, caps_included);
}

}  // namespace umbilic
