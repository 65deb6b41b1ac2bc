// SPDX-License-Identifier: MIT
/// \file
/// The patches' second derivatives at flat caps, with n frozen, against a second implementation: densities of jets by
/// the tables, differentiated once by dual numbers and once by differences.
#include <gtest/gtest.h>

#include "energy/density_values.h"
#include "energy/dual.h"
#include "energy/energy_hessian.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

constexpr Weights kBlend{0.5, 0.25, 1e-3, 2e-3, 1e-3, 3e-3, 2e-3, 1e-5};

/// The integral over one patch of rho |X_u x X_v| + area_slope |X_u x X_v|, with the flat cap's n frozen, and its
/// slope along a direction.
class FrozenPatch {
 public:
  FrozenPatch(const PatchSet& set, const Vector3& normal, const Weights& weights, double area_slope)
      : table_(basis_table(set.kind, samples_of(set.kind, kFewPoints), 1, kDerivativeCount)),
        flat_(set.kind.shape == CapShape::kFlat),
        normal_(normal),
        weights_(weights),
        area_slope_(area_slope) {}

  double slope(const Points& local, const Points& direction) const {
    const Points jets = moved(local), change = moved(direction);
    Dual sum = 0;
    for (int s = 0; s < table_.distinct; ++s) {
      Jet<Dual> jet;
      const auto to = vectors(jet);
      for (int d = 0; d < 9; ++d) {
        const auto x = jets.row(d * table_.samples + s), t = change.row(d * table_.samples + s);
        *to[d] = {Dual(x[0], t[0]), Dual(x[1], t[1]), Dual(x[2], t[2])};
      }
      const Curvature<Dual> k = CurvatureFrame<Dual, true>(jet).value();
      Curvature<Dual> unused;
      const Dual density = weighted_density<0>(weights_.data(), k, Dual(0), unused) +
                           third_order_density(weights_.data(), k, Dual(0), unused);
      sum += Dual(table_.weights[s]) * (density + Dual(area_slope_)) * k.area;
    }
    return sum.dx;
  }

 private:
  /// W P - (flattening P n) n^T, linear in P.
  Points moved(const Points& local) const {
    Points jets = table_.view(1, table_.basis) * local;
    if (flat_) jets -= (table_.view(1, table_.flattening) * (local * normal_)) * normal_.transpose();
    return jets;
  }

  BasisTable table_;
  bool flat_;
  Vector3 normal_;
  Weights weights_;
  double area_slope_;
};

Points local_rows(const PatchSet& set, int patch, const Points& points) {
  Points local(set.columns, 3);
  for (int i = 0; i < set.columns; ++i) local.row(i) = points.row(set.points[set.columns * patch + i]);
  return local;
}

/// a^T H b of the kernel's matrix, of which the lower triangle counts.
double product(const double* block, int columns, const Points& a, const Points& b) {
  const int size = 3 * columns, count = static_cast<int>(a.rows());
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    for (int e = 0; e < 3; ++e) {
      for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
          const bool lower = c > e || (c == e && i >= j);
          const int row = c * columns + i, column = e * columns + j;
          sum += a(i, c) * b(j, e) * (lower ? block[row * size + column] : block[column * size + row]);
        }
      }
    }
  }
  return sum;
}

TEST(EnergyHessian, of_every_patch_with_flat_caps_is_the_second_derivative_with_the_normals_frozen) {
  for (const int level : {1, 2}) {
    const Refined mesh = rough(trapezohedron(5), level, 0.02, 4);
    const PatchLayout layout(mesh.mesh, CapKind::kFlat);
    const JetEvaluator jets(layout, kFewPoints);
    const EnergyValue value = SurfaceEnergy(jets, kBlend).evaluate(mesh.control, nullptr);
    EnergyHessian hessian(layout, kFewPoints, kBlend);
    hessian.move_to(mesh.control, value);
    Weights weights = kBlend;  // the energy varies with the area factor and its slope frozen
    for (int f = 0; f < kFunctionalCount; ++f) weights[f] *= area_to_the(area_power(f), value.area);
    const std::vector<FlatFrame> frames = flat_frames(layout, mesh.control);
    HessianMemory memory;
    std::vector<double> block;
    Random random(5);
    for (int s = 0; s < static_cast<int>(layout.sets().size()); ++s) {
      const PatchSet& set = layout.sets()[s];
      for (int p = 0; p < set.count(); p += 7) {
        const Vector3 normal = set.caps.empty() ? Vector3::UnitX() : frames[set.caps[p]].normal;
        const FrozenPatch patch(set, normal, weights, value.area_slope);
        const Points local = local_rows(set, p, mesh.control);
        const Points a = random.points(set.columns), b = random.points(set.columns);
        const double h = 1e-6;
        const auto slope = [&](double t) { return patch.slope(local + t * a, b); };
        const double difference = (8 * (slope(h) - slope(-h)) - (slope(2 * h) - slope(-2 * h))) / (12 * h);
        // Differences of order 4 lose about half the digits; the density's are lost near umbilics.
        hessian.patch(s, p, memory, block);
        EXPECT_NEAR(product(block.data(), hessian.columns(s), a, b) / difference, 1, 1e-6)
            << "level " << level << " set " << s << " patch " << p;
      }
    }
  }
}

}  // namespace
}  // namespace umbilic::test
