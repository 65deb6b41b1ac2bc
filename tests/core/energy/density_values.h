// SPDX-License-Identifier: MIT
/// \file
/// All densities of one jet, and jets without any symmetry.
#pragma once

#include <array>

#include "energy/densities.h"
#include "energy/functional.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {

using DensityValues = std::array<double, kFunctionalCount>;

inline DensityValues densities(const Curvature<double>& k) {
  const PrincipalAngle<double> angle(k);
  Curvature<double> unused;
  DensityValues values;
  values[kBending] = bending_density(k, 0.0, unused);
  values[kWillmore] = willmore_density(k, 0.0, unused);
  values[kMvs] = mvs_density(k, angle, 0.0, unused);
  values[kMvsCross] = mvs_cross_density(k, angle, 0.0, unused);
  values[kMehlumTarrou] = mehlum_tarrou_density(k, 0.0, unused);
  values[kSecondFormVariation] = second_form_variation_density(k, 0.0, unused);
  values[kMeanCurvatureVariation] = mean_curvature_variation_density(k, 0.0, unused);
  values[kCurvednessVariation] = curvedness_variation_density(k, 0.0, unused);
  return values;
}

inline Curvature<double> curvature(const Jet<double>& jet) { return CurvatureFrame<double, true>(jet).value(); }
inline DensityValues densities(const Jet<double>& jet) { return densities(curvature(jet)); }

inline Vec3<double> vec3(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
inline Vector3 vector(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// Derivatives of size 1 that are no surface of any kind; every nine derivatives are a jet of some surface.
inline Jet<double> random_jet(Random& random) {
  Jet<double> jet;
  for (Vec3<double>* v = jet.first; v != jet.first + 2; ++v) *v = vec3(random.vector());
  jet.first[0] += Vec3<double>{1.5, 0, 0};  // away from parallel
  jet.first[1] += Vec3<double>{0, 1.5, 0};
  for (Vec3<double>& v : jet.second) v = vec3(random.vector());
  for (Vec3<double>& v : jet.third) v = vec3(random.vector());
  return jet;
}

/// The jet's vectors in order.
template <class T>
std::array<Vec3<T>*, 9> vectors(Jet<T>& jet) {
  return {&jet.first[0], &jet.first[1], &jet.second[0], &jet.second[1], &jet.second[2],
          &jet.third[0], &jet.third[1], &jet.third[2],  &jet.third[3]};
}

}  // namespace umbilic::test
