// SPDX-License-Identifier: MIT
/// \file
/// Integrates densities over jet blocks, several samples at a time.
#include "energy/surface_energy.h"

#include <algorithm>
#include <limits>

#include "base/lanes.h"
#include "energy/densities.h"
#include "energy/jet_lanes.h"

namespace umbilic {
namespace {

/// Running sums over all samples.
struct Sums {
  Lanes second{}, third{}, area{};
  double smallest = std::numeric_limits<double>::infinity();

  void add_area(Lanes weight, Lanes area_element) {
    area += weight * area_element;
    for (int i = 0; i < kLaneCount; ++i) smallest = std::min(smallest, area_element[i]);
  }
};

/// Adjoints of weight * area * density with respect to the curvature.
template <bool kThird>
Lanes integrand(const double* weights, const Curvature<Lanes>& k, Lanes weight, Curvature<Lanes>& adjoint) {
  const Lanes measure = weight * k.area;
  const Lanes density = weighted_density<kThird>(weights, k, measure, adjoint);
  adjoint.area = weight * density;
  return measure * density;
}

template <bool kSecond, bool kThird>
void integrate(const double* weights, const JetBlock& block, Sums& sums) {
  const int samples = block.samples, derivatives = block.derivatives;
  constexpr int kSecondChannel = 0, kThirdChannel = kSecond ? 1 : 0, kAreaChannel = kThirdChannel + 1;
  for (int p = 0; p < block.patches; ++p) {
    const std::size_t at = static_cast<std::size_t>(3) * samples * p;
    const Lanes multiplicity = splat(block.multiplicities[p]);
    for (int s = 0; s < samples; s += kLaneCount) {
      const Lanes weight = multiplicity * load_lanes(block.weights + s);
      const Jet<Lanes> jet = load_jet<kThird>(block.jets + at * derivatives + s, samples, derivatives);
      const CurvatureFrame<Lanes, kThird> frame(jet);
      const Curvature<Lanes>& k = frame.value();
      sums.add_area(weight, k.area);
      if constexpr (kSecond) {
        const CurvatureFrame<Lanes, false> second_frame(jet);
        Curvature<Lanes> adjoint{};
        sums.second += integrand<false>(weights, k, weight, adjoint);
        if (block.adjoints) {
          store_jet<false>(block.adjoints[kSecondChannel] + at * kSecondOrderCount + s, samples,
                           second_frame.pull_back(adjoint));
        }
      }
      if constexpr (kThird) {
        Curvature<Lanes> adjoint{};
        sums.third += integrand<true>(weights, k, weight, adjoint);
        if (block.adjoints) {
          store_jet<true>(block.adjoints[kThirdChannel] + at * kThirdOrderCount + s, samples, frame.pull_back(adjoint));
          const Vec3<Lanes> n = frame.normal() * weight;
          double* area = block.adjoints[kAreaChannel] + at * kFirstOrderCount + s;
          store_vector(area, kFirstOrderCount * samples, cross(jet.first[1], n));
          store_vector(area + samples, kFirstOrderCount * samples, cross(n, jet.first[0]));
        }
      }
    }
  }
}

}  // namespace

SurfaceEnergy::SurfaceEnergy(const JetEvaluator& jets, const Weights& weights)
    : jets_(jets),
      weights_(weights),
      second_order_(weights[kBending] != 0 || weights[kWillmore] != 0),
      third_order_(umbilic::third_order(weights)) {}

EnergyValue SurfaceEnergy::evaluate_channels(const Points& control, bool gradient,
                                             std::vector<Points>& gradients) const {
  std::vector<AdjointChannel> channels;
  if (gradient && second_order_) channels.push_back({kSecondOrderCount});
  if (gradient && third_order_) channels.insert(channels.end(), {{kThirdOrderCount}, {kFirstOrderCount}});

  Sums sums;
  const auto visit = [&](const JetBlock& block) {
    if (!third_order_) {
      integrate<true, false>(weights_.data(), block, sums);
    } else if (!second_order_) {
      integrate<false, true>(weights_.data(), block, sums);
    } else {
      integrate<true, true>(weights_.data(), block, sums);
    }
  };
  jets_.evaluate(control, third_order_ ? kThirdOrderCount : kSecondOrderCount, channels, visit, gradients);

  EnergyValue value;
  value.second = sum_lanes(sums.second);
  value.third = sum_lanes(sums.third);
  value.area = sum_lanes(sums.area);
  value.energy = value.second + value.area * value.third;
  value.regularity = sums.smallest * jets_.layout().face_count() / value.area;
  return value;
}

EnergyValue SurfaceEnergy::evaluate(const Points& control, Points* gradient) const {
  std::vector<Points> gradients;
  const EnergyValue value = evaluate_channels(control, gradient != nullptr, gradients);
  if (gradient) {
    *gradient = gradients.front();
    if (third_order_) {
      const std::size_t third = second_order_ ? 1 : 0;
      if (third == 1) {
        *gradient += value.area * gradients[1];
      } else {
        *gradient *= value.area;
      }
      *gradient += value.third * gradients[third + 1];
    }
  }
  return value;
}

EnergyValue SurfaceEnergy::evaluate_factors(const Points& control, Points& third, Points& area) const {
  std::vector<Points> gradients;
  const EnergyValue value = evaluate_channels(control, true, gradients);
  area = std::move(gradients.back());
  third = std::move(gradients[gradients.size() - 2]);
  return value;
}

SurfaceIntegrals surface_integrals(const JetEvaluator& jets, const Points& control) {
  Lanes sums[kFunctionalCount] = {}, area{}, gaussian{};
  const auto visit = [&](const JetBlock& block) {
    for (int p = 0; p < block.patches; ++p) {
      const Lanes multiplicity = splat(block.multiplicities[p]);
      const double* begin = block.jets + static_cast<std::size_t>(3) * block.samples * p * block.derivatives;
      for (int s = 0; s < block.samples; s += kLaneCount) {
        const Jet<Lanes> jet = load_jet<true>(begin + s, block.samples, block.derivatives);
        const Curvature<Lanes> k = CurvatureFrame<Lanes, true>(jet).value();
        const Lanes measure = multiplicity * load_lanes(block.weights + s) * k.area;
        const PrincipalAngle<Lanes> angle(k);
        Curvature<Lanes> unused{};
        sums[kBending] += measure * bending_density(k, Lanes{}, unused);
        sums[kWillmore] += measure * willmore_density(k, Lanes{}, unused);
        sums[kMvs] += measure * mvs_density(k, angle, Lanes{}, unused);
        sums[kMvsCross] += measure * mvs_cross_density(k, angle, Lanes{}, unused);
        sums[kMehlumTarrou] += measure * mehlum_tarrou_density(k, Lanes{}, unused);
        sums[kSecondFormVariation] += measure * second_form_variation_density(k, Lanes{}, unused);
        area += measure;
        gaussian += measure * (k.p * k.r - k.q * k.q);
      }
    }
  };
  std::vector<Points> none;
  jets.evaluate(control, kThirdOrderCount, {}, visit, none);

  SurfaceIntegrals result;
  result.area = sum_lanes(area);
  result.gaussian = sum_lanes(gaussian);
  for (int i = 0; i < kFunctionalCount; ++i) {
    result.functionals[i] = sum_lanes(sums[i]) * (is_third_order(i) ? result.area : 1);
  }
  return result;
}

}  // namespace umbilic
