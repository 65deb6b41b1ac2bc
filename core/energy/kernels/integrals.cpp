// SPDX-License-Identifier: MIT
/// \file
/// Integrates densities over jet blocks, several samples at a time.
#include "energy/kernels/integrals.h"

#include <cstddef>

#include "energy/densities.h"
#include "energy/jet_lanes.h"

namespace umbilic::UMBILIC_KERNELS {
namespace {

/// Sums over the samples, one per lane.
template <class L>
struct LaneSums {
  L second{}, third{}, parametrization{}, area{}, gaussian{}, smallest = splat<L>(__builtin_inf());

  void add_shape(const L& weight, const Curvature<L>& k) {
    const L measure = weight * k.area;
    area += measure;
    gaussian += measure * (k.p * k.r - k.q * k.q);
    smallest = k.area < smallest ? k.area : smallest;
  }

  EnergySums sums() const {
    return {sum_lanes(second), sum_lanes(third),    sum_lanes(parametrization),
            sum_lanes(area),   sum_lanes(gaussian), least_lane(smallest)};
  }
};

/// The adjoint of the curvature for the integrand weight * area * density.
template <bool kThird, class L>
L integrand(const double* weights, const Curvature<L>& k, const L& weight, Curvature<L>& adjoint) {
  const L measure = weight * k.area;
  const L density = weighted_density<kThird>(weights, k, measure, adjoint);
  adjoint.area = weight * density;
  return measure * density;
}

/// The samples [s, s + lanes) of patch p. One long function, because passing lanes to functions would go through
/// memory.
template <bool kSecond, bool kThird, bool kChristoffel, class L>
[[gnu::flatten]] inline void integrate_samples(const double* weights, const JetBlock& block, int p, int s,
                                               const L& weight, LaneSums<L>& sums) {
  constexpr int kSecondChannel = 0, kThirdChannel = kSecond ? 1 : 0, kAreaChannel = kThirdChannel + 1;
  const int samples = block.samples, derivatives = block.derivatives;
  const std::size_t at = static_cast<std::size_t>(3) * samples * p;
  const Jet<L> jet = load_jet<kThird, L>(block.jets + at * derivatives + s, samples, derivatives);
  const CurvatureFrame<L, kThird, kThird || kChristoffel> frame(jet);
  const Curvature<L>& k = frame.value();
  sums.add_shape(weight, k);
  if constexpr (kSecond) {
    Curvature<L> adjoint{};
    sums.second += integrand<false>(weights, k, weight, adjoint);
    if constexpr (kChristoffel) {
      const double parametrization = weights[kParametrization];
      const L measure = weight * k.area;
      const L density = parametrization * parametrization_density(k, measure * parametrization, adjoint);
      sums.parametrization += measure * density;
      adjoint.area += weight * density;
    }
    if (block.adjoints) {
      store_jet<false>(block.adjoints[kSecondChannel] + at * kSecondOrderCount + s, samples,
                       frame.template pull_back<false, kChristoffel>(adjoint));
    }
  }
  if constexpr (kThird) {
    Curvature<L> adjoint{};
    sums.third += integrand<true>(weights, k, weight, adjoint);
    if (block.adjoints) {
      store_jet<true>(block.adjoints[kThirdChannel] + at * kThirdOrderCount + s, samples, frame.pull_back(adjoint));
      const Vec3<L> n = frame.normal() * weight;
      double* area = block.adjoints[kAreaChannel] + at * kFirstOrderCount + s;
      store_vector(area, kFirstOrderCount * samples, cross(jet.first[1], n));
      store_vector(area + samples, kFirstOrderCount * samples, cross(n, jet.first[0]));
    }
  }
}

template <bool kSecond, bool kThird, bool kChristoffel>
BlockEnergies integrate_block(const double* weights, const JetBlock& block) {
  LaneSums<Lanes> wide;
  LaneSums<ShortLanes> rest;
  for (int p = 0; p < block.patches; ++p) {
    const double multiplicity = block.multiplicities[p];
    int s = 0;
    for (; s + kLaneCount <= block.samples; s += kLaneCount) {
      const Lanes weight = multiplicity * load_lanes(block.weights + s);
      integrate_samples<kSecond, kThird, kChristoffel>(weights, block, p, s, weight, wide);
    }
    if constexpr (kShortLaneCount < kLaneCount) {
      for (; s < block.samples; s += kShortLaneCount) {
        const ShortLanes weight = multiplicity * load_lanes<ShortLanes>(block.weights + s);
        integrate_samples<kSecond, kThird, kChristoffel>(weights, block, p, s, weight, rest);
      }
    }
  }
  return {wide.sums(), rest.sums()};
}

template <class L>
struct LaneFunctionals {
  L functionals[kFunctionalCount] = {}, parametrization{}, area{}, gaussian{};

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
    parametrization += measure * parametrization_density(k, none, unused);
    area += measure;
    gaussian += measure * (k.p * k.r - k.q * k.q);
  }

  FunctionalSums sums() const {
    FunctionalSums result{{}, sum_lanes(parametrization), sum_lanes(area), sum_lanes(gaussian)};
    for (int i = 0; i < kFunctionalCount; ++i) result.functionals[i] = sum_lanes(functionals[i]);
    return result;
  }
};

}  // namespace

BlockEnergies integrate(const double* weights, bool second_order, bool third_order, const JetBlock& block) {
  const bool christoffel = weights[kParametrization] != 0;
  if (!second_order) return integrate_block<false, true, false>(weights, block);
  if (third_order) {
    return christoffel ? integrate_block<true, true, true>(weights, block)
                       : integrate_block<true, true, false>(weights, block);
  }
  return christoffel ? integrate_block<true, false, true>(weights, block)
                     : integrate_block<true, false, false>(weights, block);
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
