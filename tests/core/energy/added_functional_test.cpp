// SPDX-License-Identifier: MIT
/// \file
/// The worked example of core/energy/README.md: a density that the library does not have, written as the library's are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "energy/density_values.h"
#include "energy/dual.h"

namespace umbilic::test {
namespace {

/// (kappa1 - kappa2)^2, in 1/length^2: 0 where the surface is umbilic, as on spheres and planes.
template <class T>
T deviation_density(const Curvature<T>& k, const T& scale, Curvature<T>& adjoint) {
  const T difference = k.p - k.r;
  adjoint.p += 2.0 * scale * difference;
  adjoint.q += 8.0 * scale * k.q;
  adjoint.r -= 2.0 * scale * difference;
  return difference * difference + 4.0 * k.q * k.q;
}

TEST(AddedFunctional, is_bending_without_twice_the_gaussian_curvature) {
  Random random(11);
  for (int trial = 0; trial < 20; ++trial) {
    const Curvature<double> k = curvature(random_jet(random));
    Curvature<double> unused;
    const double bending = densities(k)[kBending], gaussian = k.p * k.r - k.q * k.q;
    EXPECT_NEAR(deviation_density(k, 0.0, unused), bending - 2 * gaussian, 1e-12 * bending);
  }
}

/// Derivatives of deviation_density |X_u x X_v| by the jet, as the energy's kernels make them.
Jet<double> deviation_gradient(const Jet<double>& jet) {
  const CurvatureFrame<double, false> frame(jet);
  Curvature<double> adjoint;
  adjoint.area = deviation_density(frame.value(), frame.value().area, adjoint);
  return frame.pull_back(adjoint);
}

TEST(AddedFunctional, gradient_by_the_jet_equals_dual_numbers) {
  Random random(12);
  for (int trial = 0; trial < 20; ++trial) {
    Jet<double> jet = random_jet(random);
    Jet<double> gradient = deviation_gradient(jet);
    const std::array<Vec3<double>*, 9> from = vectors(jet), slopes = vectors(gradient);
    double size = 0;
    for (const Vec3<double>* slope : slopes) size = std::max(size, vector(*slope).norm());
    for (int moved = 0; moved < 9 * 3; ++moved) {
      Jet<Dual> dual;
      for (int i = 0; i < 9; ++i) {
        const auto entry = [&](double value, int axis) { return Dual(value, moved == 3 * i + axis ? 1 : 0); };
        *vectors(dual)[i] = {entry(from[i]->x, 0), entry(from[i]->y, 1), entry(from[i]->z, 2)};
      }
      const CurvatureFrame<Dual, false> frame(dual);
      Curvature<Dual> unused;
      const Dual value = deviation_density(frame.value(), Dual(0), unused) * frame.value().area;
      EXPECT_NEAR(vector(*slopes[moved / 3])[moved % 3], value.dx, 1e-10 * size) << "derivative " << moved;
    }
  }
}

}  // namespace
}  // namespace umbilic::test
