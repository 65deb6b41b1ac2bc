// SPDX-License-Identifier: MIT
/// \file
/// Assembles the Sobolev matrix in parts.
#include "optimize/sobolev.h"

#include "optimize/gauge.h"
#include "optimize/metric_rules.h"

namespace umbilic {

SobolevMetric::SobolevMetric(const SurfaceEnergy& energy, const Unknowns& unknowns, const Gauge& gauge,
                             const ClosenessTerm* closeness)
    : energy_(energy),
      unknowns_(unknowns),
      closeness_(closeness),
      scalar_(unknowns.coordinates().cartesian() && !unknowns.mapped()),
      scaling_(gauge.scaling),
      assembly_(energy.layout(), unknowns.coordinates(), scalar_),
      form_(energy.layout(), energy.weights()) {}

void SobolevMetric::begin(const Points& control, double) {
  control_ = control;
  stage_ = Stage::kArea;
}

bool SobolevMetric::advance() {
  switch (stage_) {
    case Stage::kArea:
      form_.move_to(control_, energy_.evaluate(control_, nullptr).area_factor);
      assembly_.clear(sums_);
      cursor_ = {};
      stage_ = Stage::kPatches;
      break;
    case Stage::kPatches: {
      const auto add = [&](int set, int patch) {
        assembly_.add_scalar(set, patch, form_.patch(set, patch), sums_);
        if (closeness_) assembly_.add_scalar(set, patch, closeness_->patch(set, patch), sums_);
        return form_.samples(set);
      };
      if (cursor_.visit(energy_.layout(), kSobolevSamplesPerPart, add)) stage_ = Stage::kSum;
      break;
    }
    case Stage::kSum: {
      assembly_.eliminate(sums_);
      Eigen::SparseMatrix<double> matrix = assembly_.lower(sums_.values);
      if (unknowns_.mapped()) matrix = unknowns_.reduce(matrix);
      factor_.begin(std::move(matrix));
      stage_ = Stage::kFactor;
      [[fallthrough]];
    }
    case Stage::kFactor:
      if (!factor_.advance()) break;
      if (factor_.succeeded() && scaling_) {
        const Eigen::VectorXd size = unknowns_.pull_back(scaling_direction(control_));
        fixed_size_.set(size, solve_freely(size));
      }
      stage_ = Stage::kReady;
      break;
    case Stage::kReady: break;
  }
  return stage_ == Stage::kReady;
}

Eigen::VectorXd SobolevMetric::solve(const Eigen::VectorXd& gradient) const {
  if (!factor_.succeeded()) return gradient;  // too irregular a surface: use the identity
  return fixed_size_.project(solve_freely(gradient));
}

Eigen::VectorXd SobolevMetric::solve_freely(const Eigen::VectorXd& gradient) const {
  if (!scalar_) return factor_.solve(gradient);
  const Eigen::Map<const Points> rows(gradient.data(), gradient.size() / 3, 3);
  Eigen::VectorXd result(gradient.size());
  Eigen::Map<Points>(result.data(), rows.rows(), 3) = factor_.solve(Eigen::MatrixXd(rows));
  return result;
}

}  // namespace umbilic
