// SPDX-License-Identifier: MIT
/// \file
/// Integrates densities over jet blocks, several samples at a time.
#include "energy/surface_energy.h"

#include <algorithm>
#include <limits>

#include "base/lanes.h"
#include "energy/densities.h"

namespace umbilic {
namespace {

/// The three coordinates of one derivative at consecutive samples.
Vec3<Lanes> load_vector(const double* x, int stride) {
  return {load_lanes(x), load_lanes(x + stride), load_lanes(x + 2 * stride)};
}

void store_vector(double* x, int stride, const Vec3<Lanes>& v) {
  store_lanes(x, v.x);
  store_lanes(x + stride, v.y);
  store_lanes(x + 2 * stride, v.z);
}

template <bool kThird>
Jet<Lanes> load_jet(const double* x, int samples, int derivatives) {
  Jet<Lanes> jet;
  const int stride = derivatives * samples;
  for (int d = 0; d < 2; ++d) jet.first[d] = load_vector(x + d * samples, stride);
  for (int d = 0; d < 3; ++d) jet.second[d] = load_vector(x + (2 + d) * samples, stride);
  if constexpr (kThird) {
    for (int d = 0; d < 4; ++d) jet.third[d] = load_vector(x + (5 + d) * samples, stride);
  }
  return jet;
}

template <bool kThird>
void store_jet(double* x, int samples, const Jet<Lanes>& jet) {
  const int stride = (kThird ? kThirdOrderCount : kSecondOrderCount) * samples;
  for (int d = 0; d < 2; ++d) store_vector(x + d * samples, stride, jet.first[d]);
  for (int d = 0; d < 3; ++d) store_vector(x + (2 + d) * samples, stride, jet.second[d]);
  if constexpr (kThird) {
    for (int d = 0; d < 4; ++d) store_vector(x + (5 + d) * samples, stride, jet.third[d]);
  }
}

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
      third_order_(std::any_of(weights.begin() + kMvs, weights.end(), [](double w) { return w != 0; })) {}

EnergyValue SurfaceEnergy::evaluate(const Points& control, Points* gradient) const {
  std::vector<AdjointChannel> channels;
  if (gradient && second_order_) channels.push_back({kSecondOrderCount});
  if (gradient && third_order_) channels.insert(channels.end(), {{kThirdOrderCount}, {kFirstOrderCount}});

  Sums sums;
  std::vector<Points> gradients;
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
