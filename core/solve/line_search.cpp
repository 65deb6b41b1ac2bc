// SPDX-License-Identifier: MIT
/// \file
/// The safeguarded cubic and quadratic steps of Moré & Thuente.
#include "solve/line_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace umbilic {
namespace {

constexpr double kExtrapolateLow = 1.1, kExtrapolateHigh = 4;
constexpr double kBracketShrink = 0.66;

}  // namespace

LineSearch::LineSearch(double value, double slope, double step, LineSearchOptions options)
    : options_(options),
      start_value_(value),
      start_slope_(slope),
      step_(std::min(step, options.max_step)),
      best_{0, value, slope},
      other_{0, value, slope},
      lower_(0),
      upper_(step_ * (1 + kExtrapolateHigh)),
      width_(options.max_step),
      previous_width_(2 * options.max_step),
      largest_(options.max_step) {
  assert(slope < 0 && step > 0);
}

LineSearch::Status LineSearch::update(double value, double slope) {
  ++evaluations_;
  if (!std::isfinite(value) || !std::isfinite(slope)) return reject_not_finite();

  const double required_slope = options_.decrease * start_slope_;
  const double bound = start_value_ + step_ * required_slope;
  if (first_stage_ && value <= bound && slope >= 0) first_stage_ = false;
  if (value <= bound && std::abs(slope) <= -options_.curvature * start_slope_) return Status::kDone;
  const bool narrow = bracketed_ && upper_ - lower_ <= options_.width * upper_;
  const bool at_maximum = step_ >= largest_ && value <= bound && slope <= required_slope;
  if (narrow || at_maximum || evaluations_ >= options_.max_evaluations) {
    if (value <= bound && value < start_value_) return Status::kDone;  // skips the curvature condition
    return Status::kFailed;
  }

  // The first stage works with phi(t) - decrease t phi'(0). A minimum of it satisfies the decrease condition.
  if (first_stage_ && value <= best_.value && value > bound) {
    const auto shifted = [&](const Point& p) {
      return Point{p.step, p.value - p.step * required_slope, p.slope - required_slope};
    };
    const Point trial = shifted({step_, value, slope});
    best_ = shifted(best_);
    other_ = shifted(other_);
    choose_step(trial);
    for (Point* p : {&best_, &other_}) {
      p->value += p->step * required_slope;
      p->slope += required_slope;
    }
  } else {
    choose_step({step_, value, slope});
  }

  if (bracketed_) {
    if (std::abs(other_.step - best_.step) >= kBracketShrink * previous_width_) {
      step_ = best_.step + 0.5 * (other_.step - best_.step);
    }
    previous_width_ = width_;
    width_ = std::abs(other_.step - best_.step);
    lower_ = std::min(best_.step, other_.step);
    upper_ = std::max(best_.step, other_.step);
  } else {
    lower_ = step_ + kExtrapolateLow * (step_ - best_.step);
    upper_ = step_ + kExtrapolateHigh * (step_ - best_.step);
  }
  step_ = std::clamp(step_, 0.0, largest_);
  if (bracketed_ && (step_ <= lower_ || step_ >= upper_ || upper_ - lower_ <= options_.width * upper_)) {
    step_ = best_.step;
  }
  if (step_ == 0) step_ = 0.5 * upper_;
  return Status::kEvaluate;
}

LineSearch::Status LineSearch::reject_not_finite() {
  if (evaluations_ >= options_.max_evaluations) return Status::kFailed;
  largest_ = best_.step + 0.5 * (step_ - best_.step);
  step_ = best_.step + 0.25 * (step_ - best_.step);
  return step_ > 0 ? Status::kEvaluate : Status::kFailed;
}

double LineSearch::trial_step(const Point& best, const Point& other, const Point& trial) const {
  const bool opposite = trial.slope * best.slope < 0;
  const double theta = 3 * (best.value - trial.value) / (trial.step - best.step) + best.slope + trial.slope;
  const double scale = std::max({std::abs(theta), std::abs(best.slope), std::abs(trial.slope)});
  const double discriminant = (theta / scale) * (theta / scale) - (best.slope / scale) * (trial.slope / scale);
  const double root = scale * std::sqrt(std::max(0.0, discriminant)) * (trial.step < best.step ? -1 : 1);

  if (trial.value > best.value) {  // higher: the cubic's step if it is closer, else halfway to the quadratic's
    const double ratio = (root - best.slope + theta) / (root - best.slope + root + trial.slope);
    const double cubic = best.step + ratio * (trial.step - best.step);
    const double chord = (best.value - trial.value) / (trial.step - best.step) + best.slope;
    const double quadratic = best.step + best.slope / chord / 2 * (trial.step - best.step);
    return std::abs(cubic - best.step) < std::abs(quadratic - best.step) ? cubic : cubic + (quadratic - cubic) / 2;
  }
  const double gamma = -root;
  const double secant = trial.step + trial.slope / (trial.slope - best.slope) * (best.step - trial.step);
  if (opposite) {  // lower with opposite slopes: the farther of cubic and secant
    const double ratio = (gamma - trial.slope + theta) / (gamma - trial.slope + gamma + best.slope);
    const double cubic = trial.step + ratio * (best.step - trial.step);
    return std::abs(cubic - trial.step) > std::abs(secant - trial.step) ? cubic : secant;
  }
  if (std::abs(trial.slope) < std::abs(best.slope)) {  // lower, the slope flattens
    const double ratio = (gamma - trial.slope + theta) / (gamma + best.slope - trial.slope + gamma);
    double cubic = trial.step > best.step ? upper_ : lower_;
    if (ratio < 0 && gamma != 0) cubic = trial.step + ratio * (best.step - trial.step);
    if (bracketed_) {
      const double nearer = std::abs(cubic - trial.step) < std::abs(secant - trial.step) ? cubic : secant;
      const double limit = trial.step + kBracketShrink * (other.step - trial.step);
      return trial.step > best.step ? std::min(limit, nearer) : std::max(limit, nearer);
    }
    const double farther = std::abs(cubic - trial.step) > std::abs(secant - trial.step) ? cubic : secant;
    return std::clamp(farther, lower_, upper_);
  }
  if (!bracketed_) return trial.step > best.step ? upper_ : lower_;  // lower, the slope does not flatten
  const double theta_other = 3 * (trial.value - other.value) / (other.step - trial.step) + other.slope + trial.slope;
  const double scale_other = std::max({std::abs(theta_other), std::abs(other.slope), std::abs(trial.slope)});
  const double square = (theta_other / scale_other) * (theta_other / scale_other) -
                        (other.slope / scale_other) * (trial.slope / scale_other);
  const double gamma_other = scale_other * std::sqrt(std::max(0.0, square)) * (trial.step > other.step ? -1 : 1);
  const double ratio =
      (gamma_other - trial.slope + theta_other) / (gamma_other - trial.slope + gamma_other + other.slope);
  return trial.step + ratio * (other.step - trial.step);
}

void LineSearch::choose_step(Point trial) {
  const double next = trial_step(best_, other_, trial);
  const bool opposite = trial.slope * best_.slope < 0;
  if (trial.value > best_.value) {
    other_ = trial;
    bracketed_ = true;
  } else {
    if (opposite) {
      other_ = best_;
      bracketed_ = true;
    }
    best_ = trial;
  }
  step_ = next;
}

}  // namespace umbilic
