// SPDX-License-Identifier: MIT
/// \file
/// Assembles both matrices in one pass over the patches.
#include "optimize/hessian_assembly.h"

#include "base/threads.h"
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
  PatchMemory memory;
  PatchTerms terms;
  for (int set = 0; set < static_cast<int>(layout.sets().size()); ++set) {
    for (int p = 0; p < layout.sets()[set].count(); ++p) {
      assembly_.scalar_terms(set, p, closeness_->patch(set, p, memory), terms);
      assembly_.add(set, p, terms, closeness_sums_);
    }
  }
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
        Points slope, area;
        value = energy_.evaluate_factors(control_, slope, area);
        factors_ << unknowns_.pull_back(area), unknowns_.pull_back(slope);
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
    case Stage::kPatches:
      add_patches();
      if (cursor_.ended(jets_.layout())) stage_ = Stage::kReduce;
      break;
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

void HessianAssembly::add_patches() {
  const std::vector<PatchNumber> part = cursor_.advance(jets_.layout(), samples_at_once(kHessianSamplesPerPart),
                                                        [&](int set) { return hessian_.samples(set); });
  memories_.resize(thread_count());
  terms_.resize(slot_count());
  in_order(
      static_cast<int>(part.size()), slot_count(),
      [&](int i, int slot, int member) {
        const auto [set, patch] = part[i];
        Memory& memory = memories_[member];
        hessian_.patch(set, patch, memory.hessian, memory.block);
        assembly_.terms(set, patch, memory.block.data(), hessian_.columns(set), terms_[slot].hessian);
        assembly_.scalar_terms(set, patch, sobolev_.patch(set, patch, memory.sobolev), terms_[slot].sobolev);
      },
      [&](int i, int slot) {
        assembly_.add(part[i].set, part[i].patch, terms_[slot].hessian, hessian_sums_);
        assembly_.add(part[i].set, part[i].patch, terms_[slot].sobolev, sobolev_sums_);
      });
  patches_done_ += static_cast<int>(part.size());
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
