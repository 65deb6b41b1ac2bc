// SPDX-License-Identifier: MIT
/// \file
/// Sums blocks of jets, and applies the product rule to powers of the area times integrals.
#include "energy/surface_energy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace umbilic {
namespace {

void add(const EnergySums& part, EnergySums& sums) {
  for (int p = 0; p < kAreaPowerCount; ++p) sums.integrals[p] += part.integrals[p];
  sums.parametrization += part.parametrization;
  sums.area += part.area;
  sums.gaussian += part.gaussian;
  if (part.smallest < sums.smallest) sums.smallest = part.smallest;
}

void add(const FunctionalSums& part, FunctionalSums& sums) {
  for (int i = 0; i < kFunctionalCount; ++i) sums.functionals[i] += part.functionals[i];
  for (int i = 0; i < kInvariantCount; ++i) sums.invariants[i] += part.invariants[i];
  sums.parametrization += part.parametrization;
  sums.area += part.area;
  sums.gaussian += part.gaussian;
}

/// Those of an energy with the parametrization's term, whose density counts as one of power 0.
AreaPowers with_parametrization(AreaPowers powers, double parametrization) {
  powers.has[0] |= parametrization != 0;
  return powers;
}

/// Energy and slope from the integrals.
void apply_powers(EnergyValue& value, bool fixed_area) {
  for (int p = 0; p < kAreaPowerCount; ++p) {
    value.energy += area_to_the(p, value.area_factor) * value.integrals[p];
    if (p > 0 && !fixed_area) value.area_slope += p * area_to_the(p - 1, value.area_factor) * value.integrals[p];
  }
}

}  // namespace

SurfaceEnergy::SurfaceEnergy(const JetEvaluator& jets, const Weights& weights, std::optional<double> fixed_area)
    : jets_(jets), weights_(weights), fixed_area_(fixed_area), powers_(area_powers(weights)) {}

EnergyValue SurfaceEnergy::evaluate_channels(const Points& control, double parametrization, bool gradient,
                                             std::vector<Points>& gradients) const {
  std::array<double, kDensityCount> densities{};
  std::copy(weights_.begin(), weights_.end(), densities.begin());
  densities[kParametrization] = parametrization;
  const AreaPowers powers = with_parametrization(powers_, parametrization);
  AdjointChannel channels[kAreaPowerCount + 1];
  std::size_t count = 0;
  for (int p = 0; gradient && p < kAreaPowerCount; ++p) {
    if (powers.has[p]) channels[count++] = {p == 0 ? kSecondOrderCount : kThirdOrderCount};
  }
  if (gradient && third_order()) channels[count++] = {kFirstOrderCount};

  const EnergyKernels& kernels = energy_kernels();
  blocks_.resize(jets_.block_count());
  const auto visit = [&](int number, const JetBlock& block) {
    blocks_[number] = kernels.integrate(densities.data(), powers, block);
  };
  jets_.evaluate(control, third_order() ? kThirdOrderCount : kSecondOrderCount, {channels, count}, std::ref(visit),
                 gradients);
  EnergySums sums{{}, 0, 0, 0, std::numeric_limits<double>::infinity()};
  for (const BlockEnergies& block : blocks_) {
    add(block.wide, sums);
    add(block.rest, sums);
  }

  EnergyValue value;
  std::copy(std::begin(sums.integrals), std::end(sums.integrals), value.integrals.begin());
  value.parametrization = sums.parametrization;
  value.area = sums.area;
  value.gaussian = sums.gaussian;
  value.area_factor = fixed_area_.value_or(value.area);
  apply_powers(value, fixed_area_.has_value());
  value.regularity = sums.smallest * jets_.layout().face_count() / value.area;
  return value;
}

EnergyValue SurfaceEnergy::evaluate(const Points& control, Points* gradient, double parametrization) const {
  std::vector<Points> none;
  const EnergyValue value =
      evaluate_channels(control, parametrization, gradient != nullptr, gradient ? gradients_ : none);
  if (gradient) {
    const AreaPowers powers = with_parametrization(powers_, parametrization);
    std::size_t channel = 0;
    for (int p = 0; p < kAreaPowerCount; ++p) {
      if (!powers.has[p]) continue;
      const double factor = area_to_the(p, value.area_factor);
      if (channel == 0) {
        *gradient = factor * gradients_[0];
      } else {
        *gradient += factor * gradients_[channel];
      }
      ++channel;
    }
    if (has_area_product()) *gradient += value.area_slope * gradients_[channel];
  }
  return value;
}

EnergyValue SurfaceEnergy::evaluate_factors(const Points& control, Points& slope, Points& area) const {
  std::vector<Points> gradients;
  const EnergyValue value = evaluate_channels(control, 0, true, gradients);
  area = std::move(gradients.back());
  slope = Points::Zero(area.rows(), 3);
  std::size_t channel = powers_.has[0] ? 1 : 0;
  for (int p = 1; p < kAreaPowerCount; ++p) {
    if (!powers_.has[p]) continue;
    slope += p * area_to_the(p - 1, value.area_factor) * gradients[channel++];
    if (p > 1) slope += p * (p - 1) / 2 * area_to_the(p - 2, value.area_factor) * value.integrals[p] * area;
  }
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
    result.functionals[i] = sums.functionals[i] * area_to_the(area_power(i), result.area);
  }
  for (int i = 0; i < kInvariantCount; ++i) {
    result.invariants[i] = -sums.invariants[i] * std::pow(result.area, area_exponent(static_cast<Invariant>(i)));
  }
  return result;
}

}  // namespace umbilic
