// SPDX-License-Identifier: MIT
/// \file
/// Brackets the weight, and interpolates.
#include "driver/closeness_search.h"

#include <algorithm>
#include <cmath>

namespace umbilic {
namespace {

/// Where in the accepted interval to aim, relative to the bound.
constexpr double kTarget = 0.95;
/// The factor by which a weight is changed as long as there are trials on one side only.
constexpr double kStep = 10;
/// How near an interpolated weight may come to one of its ends, as a part of the interval's logarithm.
constexpr double kMargin = 0.1;

}  // namespace

bool ClosenessSearch::accepts(double deviation) {
  const bool far = !(deviation <= bound_), near = deviation < kLeast * bound_;
  if ((!far && !near) || (near && !binds())) return true;
  if (++trials_ >= kMostTrials && near) return true;
  if (trials_ >= 2 * kMostTrials) return true;
  (far ? too_far_ : too_near_) = Trial{weight_, deviation};
  if (!too_far_ || !too_near_) {
    weight_ *= far ? kStep : 1 / kStep;
    return false;
  }
  const double low = std::log(too_far_->weight), high = std::log(too_near_->weight);
  const double above = std::log(too_far_->deviation / (kTarget * bound_)),
               below = std::log(std::max(too_near_->deviation, 1e-12 * bound_) / (kTarget * bound_));
  const double part = std::isfinite(above) ? above / (above - below) : 0.5;
  weight_ = std::exp(low + std::clamp(part, kMargin, 1 - kMargin) * (high - low));
  return false;
}

}  // namespace umbilic
