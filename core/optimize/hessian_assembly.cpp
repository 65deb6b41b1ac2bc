// SPDX-License-Identifier: MIT
/// \file
/// Assembles both matrices in one pass over the patches.
#include "optimize/hessian_assembly.h"

#include <limits>

#include "optimize/metric_rules.h"

namespace umbilic {

HessianAssembly::HessianAssembly(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                                 const QuadratureRule& rule, double umbilic_eta, std::optional<double> fixed_area,
                                 const ClosenessTerm* closeness)
    : unknowns_(unknowns),
      jets_(layout, rule),
      energy_(jets_, weights, fixed_area),
      assembly_(layout, unknowns.coordinates()),
      sobolev_(layout, weights),
      hessian_(layout, rule, weights, umbilic_eta),
      closeness_(closeness) {
  if (!closeness_) return;
  assembly_.clear(closeness_sums_);
  PatchCursor all;
  all.visit(layout, std::numeric_limits<int>::max(), [&](int set, int patch) {
    assembly_.add_scalar(set, patch, closeness_->patch(set, patch), closeness_sums_);
    return 0;
  });
  assembly_.eliminate(closeness_sums_);
}

double HessianAssembly::progress() const {
  return stage_ == Stage::kFactors ? 0 : static_cast<double>(patches_done_) / jets_.layout().patch_count();
}

void HessianAssembly::begin(const Points& control, double parametrization) {
  control_ = control;
  parametrization_ = parametrization;
  stage_ = Stage::kFactors;
}

bool HessianAssembly::advance() {
  switch (stage_) {
    case Stage::kFactors: {
      EnergyValue value;
      factors_.resize(unknowns_.count(), energy_.has_area_product() ? 2 : 0);
      if (energy_.has_area_product()) {
        Points third, area;
        value = energy_.evaluate_factors(control_, third, area);
        factors_ << unknowns_.pull_back(area), unknowns_.pull_back(third);
      } else {
        value = energy_.evaluate(control_, nullptr);
      }
      hessian_.move_to(control_, value, parametrization_);
      sobolev_.move_to(control_, value.area_factor);
      assembly_.clear(hessian_sums_);
      assembly_.clear(sobolev_sums_);
      cursor_ = {};
      patches_done_ = 0;
      stage_ = Stage::kPatches;
      break;
    }
    case Stage::kPatches: {
      const auto add = [&](int set, int patch) {
        assembly_.add(set, patch, hessian_.patch(set, patch), hessian_.columns(set), hessian_sums_);
        assembly_.add_scalar(set, patch, sobolev_.patch(set, patch), sobolev_sums_);
        ++patches_done_;
        return hessian_.samples(set);
      };
      if (cursor_.visit(jets_.layout(), kHessianSamplesPerPart, add)) stage_ = Stage::kReduce;
      break;
    }
    case Stage::kReduce:
      assembly_.eliminate(hessian_sums_);
      assembly_.eliminate(sobolev_sums_);
      for (std::size_t i = 0; closeness_ && i < hessian_sums_.values.size(); ++i) {
        hessian_sums_.values[i] += closeness_sums_.values[i];
      }
      if (unknowns_.mapped()) {
        reduced_hessian_ = unknowns_.reduce(assembly_.lower(hessian_sums_.values));
        reduced_sobolev_ = unknowns_.reduce(assembly_.lower(sobolev_sums_.values));
      }
      stage_ = Stage::kReady;
      break;
    case Stage::kReady: break;
  }
  return stage_ == Stage::kReady;
}

HessianAssembly::Matrix HessianAssembly::combine(double hessian_factor, double sobolev_factor) const {
  if (unknowns_.mapped()) return hessian_factor * reduced_hessian_ + sobolev_factor * reduced_sobolev_;
  std::vector<double> values(assembly_.nonzeros());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = hessian_factor * hessian_sums_.values[i] + sobolev_factor * sobolev_sums_.values[i];
  }
  return assembly_.lower(values);
}

}  // namespace umbilic
