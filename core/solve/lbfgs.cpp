// SPDX-License-Identifier: MIT
/// \file
/// The two-loop recursion, its stop rules, and what happens when a line search fails.
#include "solve/lbfgs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace umbilic {
namespace {

/// Relative rounding error of an objective that sums many terms.
constexpr double kRelativeRoundOff = 1e-13;

/// If a line search fails and the predicted decrease is below this multiple of the rounding error, rounding is the
/// reason.
constexpr double kStalledByRoundOff = 1e3;

/// A pair is kept only if the cosine of s and y is larger: below, rounding decides its sign.
constexpr double kLeastCurvature = 1e-12;

/// How far a line search may go, relative to the largest displacement of its first trial.
constexpr double kLongestStep = 1e3;

}  // namespace

Lbfgs::Lbfgs(const Objective& objective, const Metric& metric, Eigen::VectorXd start, LbfgsOptions options)
    : objective_(objective),
      metric_(&metric),
      options_(options),
      unknowns_(std::move(start)),
      best_(unknowns_),
      best_value_(std::numeric_limits<double>::quiet_NaN()),
      best_gradient_norm_(std::numeric_limits<double>::quiet_NaN()),
      predicted_(std::numeric_limits<double>::quiet_NaN()) {}

void Lbfgs::evaluate(const Eigen::VectorXd& at) {
  objective_.evaluate(at, trial_);
  ++evaluations_;
  if (std::isfinite(trial_.value) && trial_.gradient.allFinite() && !(trial_.value >= best_value_)) {
    best_ = at;
    best_value_ = trial_.value;
    best_gradient_norm_ = trial_.gradient.norm();
  }
}

bool Lbfgs::step() {
  if (stop_) return true;
  if (evaluations_ == 0) {
    evaluate(unknowns_);
    value_ = trial_.value;
    gradient_ = trial_.gradient;
    recent_values_.push_back(value_);
    if (!std::isfinite(value_) || !gradient_.allFinite()) {
      stop_ = StopReason::kNotFinite;
    } else if (options_.max_iterations == 0) {
      stop_ = StopReason::kMaxIterations;
    }
    return ended();
  }
  if (!search_) begin_iteration();
  if (stop_) return true;
  trial_unknowns_ = unknowns_ + search_->step() * direction_;
  evaluate(trial_unknowns_);
  const double slope = trial_.gradient.allFinite() ? trial_.gradient.dot(direction_) : std::nan("");
  switch (search_->update(trial_.value, slope)) {
    case LineSearch::Status::kEvaluate: break;
    case LineSearch::Status::kDone: end_iteration(); break;
    case LineSearch::Status::kFailed: restart_or_stall(); break;
  }
  return ended();
}

void Lbfgs::resume(double tolerance) {
  assert(stop_ == StopReason::kConverged || stop_ == StopReason::kRoundOff || stop_ == StopReason::kLineSearchStalled);
  options_.tolerance = tolerance;
  stop_.reset();
  search_.reset();
  pairs_.clear();
  restarted_ = false;
  recent_values_.assign(1, value_);
}

void Lbfgs::restart(double tolerance, double model_alone) {
  options_.tolerance = tolerance;
  options_.model_alone = model_alone;
  stop_.reset();
  search_.reset();
  pairs_.clear();
  restarted_ = false;
  latest_gain_ = 1;
  unknowns_ = best_;
  best_value_ = std::numeric_limits<double>::quiet_NaN();
  evaluate(unknowns_);
  value_ = trial_.value;
  gradient_ = trial_.gradient;
  recent_values_.assign(1, value_);
}

Eigen::VectorXd Lbfgs::direction() const {
  Eigen::VectorXd d = -gradient_;
  std::vector<double> alpha(pairs_.size());
  for (std::size_t i = pairs_.size(); i-- > 0;) {
    alpha[i] = pairs_[i].rho * pairs_[i].s.dot(d);
    d -= alpha[i] * pairs_[i].y;
  }
  d = metric_->solve(d);
  if (!pairs_.empty()) {
    const Pair& last = pairs_.back();
    const double gamma = 1 / (last.rho * last.y.dot(metric_->solve(last.y)));
    if (std::isfinite(gamma) && gamma > 0) d *= gamma;
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    d += (alpha[i] - pairs_[i].rho * pairs_[i].y.dot(d)) * pairs_[i].s;
  }
  return d;
}

/// The decrease still to come if the decreases of the last two spans of iterations go on as a geometric sequence. At
/// least the decrease of the last span, since a fast beginning says little about a slow end.
double Lbfgs::trend() const {
  const double middle = recent_values_[options_.trend];
  const double older = recent_values_.front() - middle, newer = middle - recent_values_.back();
  return newer < older ? newer * std::max(1.0, newer / (older - newer)) : older + newer;
}

void Lbfgs::begin_iteration() {
  direction_ = direction();
  double slope = direction_.dot(gradient_);
  if (!(slope < 0) && !pairs_.empty()) {
    pairs_.clear();
    direction_ = direction();
    slope = direction_.dot(gradient_);
  }
  const double model = -slope / 2;
  const double threshold = options_.tolerance * std::max(value_, options_.floor);
  const bool has_trend = static_cast<int>(recent_values_.size()) > 2 * options_.trend;
  predicted_ = has_trend ? std::max(model, trend()) : model;
  const bool model_alone = metric_->predicts() && model <= options_.model_alone * threshold;
  if (model_alone || (has_trend && predicted_ <= threshold)) {
    stop_ = StopReason::kConverged;
  } else if (!(slope < 0) || model <= kRelativeRoundOff * std::abs(value_)) {
    stop_ = StopReason::kRoundOff;
  } else if (iterations_ >= options_.max_iterations) {
    stop_ = StopReason::kMaxIterations;
  }
  if (stop_) return;

  const double largest = direction_.cwiseAbs().maxCoeff();
  LineSearchOptions search;
  search.max_step = std::max(1.0, kLongestStep * options_.max_displacement / largest);
  model_ = model;
  search_.emplace(value_, slope, std::min(1.0, options_.max_displacement / largest), search);
}

void Lbfgs::end_iteration() {
  search_.reset();
  latest_gain_ = (value_ - trial_.value) / model_;
  ++iterations_;
  restarted_ = false;
  Pair pair{trial_unknowns_ - unknowns_, trial_.gradient - gradient_, 0};
  const double curvature = pair.s.dot(pair.y);
  if (curvature > kLeastCurvature * pair.s.norm() * pair.y.norm()) {
    pair.rho = 1 / curvature;
    pairs_.push_back(std::move(pair));
    if (static_cast<int>(pairs_.size()) > options_.memory) pairs_.pop_front();
  }
  unknowns_ = trial_unknowns_;
  gradient_ = trial_.gradient;
  value_ = trial_.value;
  recent_values_.push_back(value_);
  if (static_cast<int>(recent_values_.size()) > 2 * options_.trend + 1) recent_values_.pop_front();
  if (trial_.degenerate) stop_ = StopReason::kDegenerate;
}

void Lbfgs::restart_or_stall() {
  search_.reset();
  if (!restarted_ && !pairs_.empty()) {
    restarted_ = true;
    pairs_.clear();
    return;
  }
  const double model = -direction_.dot(gradient_) / 2;
  stop_ = model <= kStalledByRoundOff * kRelativeRoundOff * std::abs(value_) ? StopReason::kRoundOff
                                                                             : StopReason::kLineSearchStalled;
}

}  // namespace umbilic
