// SPDX-License-Identifier: MIT
/// \file
/// Assembles the Sobolev matrix in parts.
#include "optimize/sobolev.h"

#include "base/threads.h"
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
    case Stage::kPatches:
      add_patches();
      if (cursor_.ended(energy_.layout())) stage_ = Stage::kSum;
      break;
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
      ++factorizations_;
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

void SobolevMetric::add_patches() {
  const std::vector<PatchNumber> part = cursor_.advance(energy_.layout(), samples_at_once(kSobolevSamplesPerPart),
                                                        [&](int set) { return form_.samples(set); });
  memories_.resize(thread_count());
  terms_.resize(slot_count());
  in_order(
      static_cast<int>(part.size()), slot_count(),
      [&](int i, int slot, int member) {
        const auto [set, patch] = part[i];
        assembly_.scalar_terms(set, patch, form_.patch(set, patch, memories_[member].sobolev), terms_[slot].sobolev);
        if (!closeness_) return;
        assembly_.scalar_terms(set, patch, closeness_->patch(set, patch, memories_[member].closeness),
                               terms_[slot].closeness);
      },
      [&](int i, int slot) {
        assembly_.add(part[i].set, part[i].patch, terms_[slot].sobolev, sums_);
        if (closeness_) assembly_.add(part[i].set, part[i].patch, terms_[slot].closeness, sums_);
      });
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
