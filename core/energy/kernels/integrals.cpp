// SPDX-License-Identifier: MIT
/// \file
/// Integrates densities over jet blocks, several samples at a time.
#include "energy/kernels/integrals.h"

#include <cstddef>

#include "energy/densities.h"
#include "energy/jet_lanes.h"
#include "energy/odd_densities.h"

namespace umbilic::UMBILIC_KERNELS {
namespace {

/// Sums over the samples, one per lane.
template <class L>
struct LaneSums {
  L integrals[kAreaPowerCount] = {}, parametrization{}, area{}, gaussian{}, smallest = splat<L>(__builtin_inf());

  void add_shape(const L& weight, const Curvature<L>& k) {
    const L measure = weight * k.area;
    area += measure;
    gaussian += measure * (k.p * k.r - k.q * k.q);
    smallest = k.area < smallest ? k.area : smallest;
  }

  EnergySums sums() const {
    EnergySums result{{}, sum_lanes(parametrization), sum_lanes(area), sum_lanes(gaussian), least_lane(smallest)};
    for (int power = 0; power < kAreaPowerCount; ++power) result.integrals[power] = sum_lanes(integrals[power]);
    return result;
  }
};

/// The adjoint of the curvature for the integrand weight * area * density.
template <int kPower, class L>
L integrand(const double* weights, const Curvature<L>& k, const L& weight, Curvature<L>& adjoint) {
  const L measure = weight * k.area;
  const L density = weighted_density<kPower>(weights, k, measure, adjoint);
  adjoint.area = weight * density;
  return measure * density;
}

/// A power of the area as a type.
template <int kPower>
struct Power {};

/// The samples [s, s + lanes) of patch p. One long function, because passing lanes to functions would go through
/// memory.
template <bool kSecond, int kHighestPower, bool kChristoffel, class L>
[[gnu::flatten]] inline void integrate_samples(const double* weights, const AreaPowers& powers, const JetBlock& block,
                                               int p, int s, const L& weight, LaneSums<L>& sums) {
  constexpr bool kThird = kHighestPower > 0;
  const int samples = block.samples, derivatives = block.derivatives;
  const std::size_t at = static_cast<std::size_t>(3) * samples * p;
  const Jet<L> jet = load_jet<kThird, L>(block.jets + at * derivatives + s, samples, derivatives);
  const CurvatureFrame<L, kThird, kThird || kChristoffel> frame(jet);
  const Curvature<L>& k = frame.value();
  sums.add_shape(weight, k);
  if constexpr (kSecond) {
    Curvature<L> adjoint{};
    sums.integrals[0] += integrand<0>(weights, k, weight, adjoint);
    if constexpr (kChristoffel) {
      const double parametrization = weights[kParametrization];
      const L measure = weight * k.area;
      const L density = parametrization * parametrization_density(k, measure * parametrization, adjoint);
      sums.parametrization += measure * density;
      adjoint.area += weight * density;
    }
    if (block.adjoints) {
      store_jet<false>(block.adjoints[0] + at * kSecondOrderCount + s, samples,
                       frame.template pull_back<false, kChristoffel>(adjoint));
    }
  }
  if constexpr (kThird) {
    int channel = kSecond ? 1 : 0;
    const auto add = [&]<int kPower>(Power<kPower>) {
      Curvature<L> adjoint{};
      sums.integrals[kPower] += integrand<kPower>(weights, k, weight, adjoint);
      if (!block.adjoints) return;
      store_jet<true>(block.adjoints[channel++] + at * kThirdOrderCount + s, samples, frame.pull_back(adjoint));
    };
    if (kHighestPower == 1 || powers.has[1]) add(Power<1>());
    if constexpr (kHighestPower == 2) add(Power<2>());
    if (block.adjoints) {
      const Vec3<L> n = frame.normal() * weight;
      double* area = block.adjoints[channel] + at * kFirstOrderCount + s;
      store_vector(area, kFirstOrderCount * samples, cross(jet.first[1], n));
      store_vector(area + samples, kFirstOrderCount * samples, cross(n, jet.first[0]));
    }
  }
}

template <bool kSecond, int kHighestPower, bool kChristoffel>
BlockEnergies integrate_block(const double* weights, const AreaPowers& powers, const JetBlock& block) {
  LaneSums<Lanes> wide;
  LaneSums<ShortLanes> rest;
  for (int p = 0; p < block.patches; ++p) {
    const double multiplicity = block.multiplicities[p];
    int s = 0;
    for (; s + kLaneCount <= block.samples; s += kLaneCount) {
      const Lanes weight = multiplicity * load_lanes(block.weights + s);
      integrate_samples<kSecond, kHighestPower, kChristoffel>(weights, powers, block, p, s, weight, wide);
    }
    if constexpr (kShortLaneCount < kLaneCount) {
      for (; s < block.samples; s += kShortLaneCount) {
        const ShortLanes weight = multiplicity * load_lanes<ShortLanes>(block.weights + s);
        integrate_samples<kSecond, kHighestPower, kChristoffel>(weights, powers, block, p, s, weight, rest);
      }
    }
  }
  return {wide.sums(), rest.sums()};
}

template <int kHighestPower>
BlockEnergies integrate_up_to(const double* weights, const AreaPowers& powers, const JetBlock& block) {
  if constexpr (kHighestPower > 0) {
    if (!powers.has[0]) return integrate_block<false, kHighestPower, false>(weights, powers, block);
  }
  return weights[kParametrization] != 0 ? integrate_block<true, kHighestPower, true>(weights, powers, block)
                                        : integrate_block<true, kHighestPower, false>(weights, powers, block);
}

template <class L>
struct LaneInvariants {
  L values[kInvariantCount] = {};

  /// Apart from the functionals: products that both had would not be fused with sums, which changes last digits.
  [[gnu::noinline]] void add(const Curvature<L>& k, const L& measure) {
    values[kGradientForm] += measure * gradient_form_density(k);
    values[kVariationForm] += measure * variation_form_density(k);
    values[kTripleForm] += measure * triple_form_density(k);
  }
};

template <class L>
struct LaneFunctionals {
  L functionals[kFunctionalCount] = {}, parametrization{}, area{}, gaussian{};
  LaneInvariants<L> invariants;

  [[gnu::flatten]] void add(const Jet<L>& jet, const L& weight) {
    const CurvatureFrame<L, true> frame(jet);
    const Curvature<L>& k = frame.value();
    const L measure = weight * k.area, none{};
    const PrincipalAngle<L> angle(k);
    Curvature<L> unused{};
    functionals[kBending] += measure * bending_density(k, none, unused);
    functionals[kWillmore] += measure * willmore_density(k, none, unused);
    functionals[kMvs] += measure * mvs_density(k, angle, none, unused);
    functionals[kMvsCross] += measure * mvs_cross_density(k, angle, none, unused);
    functionals[kMehlumTarrou] += measure * mehlum_tarrou_density(k, none, unused);
    functionals[kSecondFormVariation] += measure * second_form_variation_density(k, none, unused);
    functionals[kMeanCurvatureVariation] += measure * mean_curvature_variation_density(k, none, unused);
    functionals[kCurvednessVariation] += measure * curvedness_variation_density(k, none, unused);
    parametrization += measure * parametrization_density(k, none, unused);
    area += measure;
    gaussian += measure * (k.p * k.r - k.q * k.q);
    invariants.add(k, measure);
  }

  FunctionalSums sums() const {
    FunctionalSums result{{}, {}, sum_lanes(parametrization), sum_lanes(area), sum_lanes(gaussian)};
    for (int i = 0; i < kFunctionalCount; ++i) result.functionals[i] = sum_lanes(functionals[i]);
    for (int i = 0; i < kInvariantCount; ++i) result.invariants[i] = sum_lanes(invariants.values[i]);
    return result;
  }
};

}  // namespace

BlockEnergies integrate(const double* weights, const AreaPowers& powers, const JetBlock& block) {
  static_assert(kAreaPowerCount == 3);
  if (powers.has[2]) return integrate_up_to<2>(weights, powers, block);
  return powers.has[1] ? integrate_up_to<1>(weights, powers, block) : integrate_up_to<0>(weights, powers, block);
}

FunctionalSums integrate_all(const JetBlock& block) {
  LaneFunctionals<ShortLanes> lanes;
  for (int p = 0; p < block.patches; ++p) {
    const double* begin = block.jets + static_cast<std::size_t>(3) * block.samples * p * block.derivatives;
    for (int s = 0; s < block.samples; s += kShortLaneCount) {
      lanes.add(load_jet<true, ShortLanes>(begin + s, block.samples, block.derivatives),
                block.multiplicities[p] * load_lanes<ShortLanes>(block.weights + s));
    }
  }
  return lanes.sums();
}

}  // namespace umbilic::UMBILIC_KERNELS
