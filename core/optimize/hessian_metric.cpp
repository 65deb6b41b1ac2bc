// SPDX-License-Identifier: MIT
/// \file
/// Factors with rising mu.
#include "optimize/hessian_metric.h"

#include <algorithm>

namespace umbilic {
namespace {

/// On surfaces between a cage and its minimizer mu ends between 10 and 1e-4.
constexpr double kStartMu = 1e-2;
constexpr double kSmallestMu = 1e-6;
constexpr double kLargestMu = 1e6;
constexpr double kFactor = 10;

}  // namespace

HessianMetric::HessianMetric(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                             const QuadratureRule& rule)
    : assembly_(layout, unknowns, weights, rule), mu_(kStartMu * kFactor) {}

void HessianMetric::begin(const Points& control) {
  assembly_.begin(control);
  assembled_ = ready_ = false;
  settled_ = mu_ <= kSmallestMu;
  mu_ = std::max(mu_ / kFactor, kSmallestMu);
}

bool HessianMetric::advance() {
  if (!assembled_) {
    assembled_ = assembly_.advance();
  } else if (!ready_) {
    ready_ = factor() || mu_ >= kLargestMu;
    if (!ready_) {
      mu_ *= kFactor;
      settled_ = true;
    }
  }
  return ready_;
}

bool HessianMetric::factor() {
  const Eigen::SparseMatrix<double> matrix = assembly_.combine(1, mu_);
  if (!analyzed_) factor_.analyzePattern(matrix);
  analyzed_ = true;
  factor_.factorize(matrix);
  if (factor_.info() != Eigen::Success) return false;
  const Eigen::MatrixXd& factors = assembly_.factors();
  if (factors.cols() == 0) return true;
  solved_ = factor_.solve(factors);
  const Eigen::Matrix2d inverse_core = Eigen::Matrix2d{{0, 1}, {1, 0}} + factors.transpose() * solved_;
  core_ = inverse_core.inverse();
  // The rank-two term keeps the sum positive definite as long as this has eigenvalues of both signs.
  return inverse_core.determinant() < 0;
}

Eigen::VectorXd HessianMetric::solve(const Eigen::VectorXd& gradient) const {
  if (factor_.info() != Eigen::Success) return gradient;  // a surface too irregular for any metric: the identity
  Eigen::VectorXd result = factor_.solve(gradient);
  if (assembly_.factors().cols() > 0) result -= solved_ * (core_ * (solved_.transpose() * gradient));
  return result;
}

}  // namespace umbilic
