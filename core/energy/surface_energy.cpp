// SPDX-License-Identifier: MIT
/// \file
/// Sums blocks of jets, and applies the product rule to area * third.
#include "energy/surface_energy.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace umbilic {
namespace {

void add(const EnergySums& part, EnergySums& sums) {
  sums.second += part.second;
  sums.third += part.third;
  sums.parametrization += part.parametrization;
  sums.area += part.area;
  sums.gaussian += part.gaussian;
  if (part.smallest < sums.smallest) sums.smallest = part.smallest;
}

void add(const FunctionalSums& part, FunctionalSums& sums) {
  for (int i = 0; i < kFunctionalCount; ++i) sums.functionals[i] += part.functionals[i];
  sums.parametrization += part.parametrization;
  sums.area += part.area;
  sums.gaussian += part.gaussian;
}

}  // namespace

SurfaceEnergy::SurfaceEnergy(const JetEvaluator& jets, const Weights& weights, std::optional<double> fixed_area)
    : jets_(jets),
      weights_(weights),
      fixed_area_(fixed_area),
      second_order_(weights[kBending] != 0 || weights[kWillmore] != 0),
      third_order_(umbilic::third_order(weights)) {}

EnergyValue SurfaceEnergy::evaluate_channels(const Points& control, double parametrization, bool gradient,
                                             std::vector<Points>& gradients) const {
  std::array<double, kDensityCount> densities{};
  std::copy(weights_.begin(), weights_.end(), densities.begin());
  densities[kParametrization] = parametrization;
  const bool second_order = second_order_ || parametrization != 0;
  AdjointChannel channels[3];
  std::size_t count = 0;
  if (gradient && second_order) channels[count++] = {kSecondOrderCount};
  if (gradient && third_order_) {
    channels[count++] = {kThirdOrderCount};
    channels[count++] = {kFirstOrderCount};
  }

  const EnergyKernels& kernels = energy_kernels();
  blocks_.resize(jets_.block_count());
  const auto visit = [&](int number, const JetBlock& block) {
    blocks_[number] = kernels.integrate(densities.data(), second_order, third_order_, block);
  };
  jets_.evaluate(control, third_order_ ? kThirdOrderCount : kSecondOrderCount, {channels, count}, std::ref(visit),
                 gradients);
  EnergySums sums{0, 0, 0, 0, 0, std::numeric_limits<double>::infinity()};
  for (const BlockEnergies& block : blocks_) {
    add(block.wide, sums);
    add(block.rest, sums);
  }

  EnergyValue value;
  value.second = sums.second;
  value.third = sums.third;
  value.parametrization = sums.parametrization;
  value.area = sums.area;
  value.gaussian = sums.gaussian;
  value.area_factor = fixed_area_.value_or(value.area);
  value.area_slope = fixed_area_ ? 0 : value.third;
  value.energy = value.second + value.area_factor * value.third;
  value.regularity = sums.smallest * jets_.layout().face_count() / value.area;
  return value;
}

EnergyValue SurfaceEnergy::evaluate(const Points& control, Points* gradient, double parametrization) const {
  std::vector<Points> none;
  const EnergyValue value =
      evaluate_channels(control, parametrization, gradient != nullptr, gradient ? gradients_ : none);
  if (gradient) {
    *gradient = gradients_.front();
    if (third_order_) {
      const std::size_t third = second_order_ || parametrization != 0 ? 1 : 0;
      if (third == 1) {
        *gradient += value.area_factor * gradients_[1];
      } else {
        *gradient *= value.area_factor;
      }
      if (has_area_product()) *gradient += value.area_slope * gradients_[third + 1];
    }
  }
  return value;
}

EnergyValue SurfaceEnergy::evaluate_factors(const Points& control, Points& third, Points& area) const {
  std::vector<Points> gradients;
  const EnergyValue value = evaluate_channels(control, 0, true, gradients);
  area = std::move(gradients.back());
  third = std::move(gradients[gradients.size() - 2]);
  return value;
}

SurfaceIntegrals surface_integrals(const JetEvaluator& jets, const Points& control) {
  const EnergyKernels& kernels = energy_kernels();
  std::vector<FunctionalSums> blocks(jets.block_count());
  const auto visit = [&](int number, const JetBlock& block) { blocks[number] = kernels.integrate_all(block); };
  std::vector<Points> none;
  jets.evaluate(control, kThirdOrderCount, {}, visit, none);
  FunctionalSums sums{};
  for (const FunctionalSums& block : blocks) add(block, sums);

  SurfaceIntegrals result;
  result.area = sums.area;
  result.parametrization = sums.parametrization;
  result.gaussian = sums.gaussian;
  for (int i = 0; i < kFunctionalCount; ++i) {
    result.functionals[i] = sums.functionals[i] * (is_third_order(i) ? result.area : 1);
  }
  return result;
}

}  // namespace umbilic
