// SPDX-License-Identifier: MIT
/// \file
/// Factors H + mu S with growing mu until it is positive definite.
#include "optimize/hessian_metric.h"

#include <algorithm>
#include <cassert>

#include "optimize/gauge.h"
#include "optimize/metric_rules.h"

namespace umbilic {

HessianMetric::HessianMetric(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                             const QuadratureRule& rule, const Gauge& gauge, std::optional<double> fixed_area,
                             const ClosenessTerm* closeness, bool newton)
    : unknowns_(unknowns),
      newton_(newton),
      scaling_(gauge.scaling),
      assembly_(layout, unknowns, weights, rule, kMetricUmbilicEta, fixed_area, closeness),
      factor_(newton ? SparseCholesky::Pivots::kNonzero : SparseCholesky::Pivots::kPositive),
      mu_(kStartMu) {}

void HessianMetric::begin(const Points& control, double parametrization) {
  assembly_.begin(control, parametrization);
  assembled_ = factoring_ = ready_ = rose_ = positive_ = must_be_positive_ = false;
  if (!newton_) {
    mu_ /= fall_;
  } else if (latest_gain_ > kGoodGain) {
    mu_ /= kMuFactor;
  } else if (latest_gain_ < kPoorGain) {
    mu_ *= kMuRise;
  }
  mu_ = std::max(mu_, kSmallestMu);
  settled_ = mu_ <= kSettledMu;
  size_gradient_ = unknowns_.pull_back(scaling_direction(control));
}

void HessianMetric::settle() {
  assert(ready_);
  factoring_ = ready_ = rose_ = positive_ = false;
  mu_ = std::min(mu_, kSettledMu);
  settled_ = true;
}

bool HessianMetric::positive() const { return !positive_ || absolute_.complete(); }  // else it is the identity

void HessianMetric::make_positive() {
  assert(ready_);
  factoring_ = ready_ = positive_ = false;
  must_be_positive_ = true;
  mu_ *= kMuFactor;
}

bool HessianMetric::predicts() const { return mu_ < kUninformativeMu && absolute_.complete(); }

bool HessianMetric::advance() {
  if (!assembled_) {
    assembled_ = assembly_.advance();
    if (assembled_ && assembly_.factors().cols() > 0) size_gradient_ = assembly_.factors().col(0);
  } else if (!ready_) {
    if (!factoring_) factor_.begin(assembly_.combine(1, mu_));
    factoring_ = !factor_.advance();
    if (!factoring_) end_factoring();
  }
  return ready_;
}

/// Whether what is factored is positive definite, or becomes so where a few eigenvalues are replaced.
bool HessianMetric::replace_negative() {
  absolute_ = {};
  if (!factor_.succeeded()) return false;
  if (!newton_) return true;
  if (factor_.negative() > kMostNegative) return false;
  absolute_ = AbsoluteInverse(factor_, assembly_.combine(0, 1), mu_);
  return absolute_.complete() || !must_be_positive_;
}

void HessianMetric::end_factoring() {
  ++factorizations_;
  positive_ = replace_negative();
  ready_ = positive_ || mu_ >= kLargestMu;
  if (!ready_) {
    mu_ *= kMuFactor;
    rose_ = settled_ = true;
    return;
  }
  fall_ = rose_ ? kMuFactor : std::min(fall_ * kMuFactor, kLargestMuFall);
  if (positive_ && scaling_) fixed_size_.set(size_gradient_, solve_freely(size_gradient_));
}

Eigen::VectorXd HessianMetric::solve(const Eigen::VectorXd& gradient) const {
  if (!positive_) return gradient;  // too irregular a surface: use the identity
  return fixed_size_.project(solve_freely(gradient));
}

}  // namespace umbilic
