// SPDX-License-Identifier: MIT
/// \file
/// Assembles both matrices in one pass over the patches, then factors with rising mu.
#include "optimize/hessian_metric.h"

#include <algorithm>

namespace umbilic {
namespace {

constexpr double kStartMu = 1e-2;
constexpr double kSmallestMu = 1e-6;
constexpr double kLargestMu = 1e6;
constexpr double kRise = 10;
constexpr double kFall = 10;

/// Samples whose contributions one `advance` adds.
constexpr int kSamplesPerPart = 300;

}  // namespace

HessianMetric::HessianMetric(const SurfaceEnergy& energy, const Coordinates& coordinates, const QuadratureRule& rule)
    : energy_(energy),
      coordinates_(coordinates),
      assembly_(energy.layout(), coordinates),
      sobolev_(energy.layout(), energy.weights()),
      hessian_(energy.layout(), rule, energy.weights()),
      mu_(kStartMu * kFall) {}

void HessianMetric::begin(const Points& control) {
  control_ = control;
  stage_ = Stage::kFactors;
}

bool HessianMetric::advance() {
  switch (stage_) {
    case Stage::kFactors: {
      EnergyValue value;
      factors_.resize(coordinates_.count(), energy_.third_order() ? 2 : 0);
      if (energy_.third_order()) {
        Points third, area;
        value = energy_.evaluate_factors(control_, third, area);
        factors_ << coordinates_.pull_back(area), coordinates_.pull_back(third);
      } else {
        value = energy_.evaluate(control_, nullptr);
      }
      hessian_.move_to(control_, value);
      sobolev_.move_to(control_, value.area);
      hessian_values_.assign(assembly_.nonzeros(), 0.0);
      sobolev_values_.assign(assembly_.nonzeros(), 0.0);
      cursor_ = {};
      mu_ = std::max(mu_ / kFall, kSmallestMu);
      stage_ = Stage::kPatches;
      break;
    }
    case Stage::kPatches: {
      const auto add = [&](int set, int patch) {
        assembly_.add(set, patch, hessian_.patch(set, patch), hessian_.columns(set), hessian_values_);
        assembly_.add_scalar(set, patch, sobolev_.patch(set, patch), sobolev_values_);
        return hessian_.samples(set);
      };
      if (cursor_.visit(energy_.layout(), kSamplesPerPart, add)) stage_ = Stage::kFactor;
      break;
    }
    case Stage::kFactor:
      if (factor() || mu_ >= kLargestMu) {
        stage_ = Stage::kReady;
      } else {
        mu_ *= kRise;
      }
      break;
    case Stage::kReady: break;
  }
  return stage_ == Stage::kReady;
}

bool HessianMetric::factor() {
  std::vector<double> values(assembly_.nonzeros());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = hessian_values_[i] + mu_ * sobolev_values_[i];
  const Eigen::SparseMatrix<double> matrix = assembly_.lower(values);
  if (!analyzed_) factor_.analyzePattern(matrix);
  analyzed_ = true;
  factor_.factorize(matrix);
  if (factor_.info() != Eigen::Success) return false;
  if (factors_.cols() == 0) return true;
  solved_ = factor_.solve(factors_);
  const Eigen::Matrix2d inverse_core = Eigen::Matrix2d{{0, 1}, {1, 0}} + factors_.transpose() * solved_;
  core_ = inverse_core.inverse();
  // Adding the rank-two term keeps the sum positive definite as long as this has eigenvalues of both signs.
  return inverse_core.determinant() < 0;
}

Eigen::VectorXd HessianMetric::solve(const Eigen::VectorXd& gradient) const {
  if (factor_.info() != Eigen::Success) return gradient;
  Eigen::VectorXd result = factor_.solve(gradient);
  if (factors_.cols() > 0) result -= solved_ * (core_ * (solved_.transpose() * gradient));
  return result;
}

}  // namespace umbilic
