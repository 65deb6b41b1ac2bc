// SPDX-License-Identifier: MIT
/// \file
/// The evaluator by tables: ranges of any size give the same jets, any order is the first, and pulling back is the
/// transpose. jets_test.cpp has tensor rules and a second implementation of the jets themselves.
#include "surface/patch_evaluator.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/rough_cages.h"
#include "surface/all_caps.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

PatchEvaluator by_tables(const PatchLayout& layout) {
  return PatchEvaluator(layout,
                        [](const PatchKind& kind) { return PatchBasis(shared_basis_table(kind, kFewPoints, 0)); });
}

Eigen::VectorXd jets_of(const PatchEvaluator& patches, PatchRange range, int derivatives, int from,
                        PatchMemory memory = {}) {
  const int size = 3 * derivatives * patches.basis(range.set).samples() * range.count;
  return Eigen::Map<const Eigen::VectorXd>(patches.jets(range, derivatives, memory, from), size);
}

TEST(PatchEvaluator, gives_patches_together_the_jets_that_it_gives_each_alone) {
  const Refined mesh = rough(trapezohedron(5), 2, 0.03, 1);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    PatchEvaluator patches = by_tables(layout);
    patches.move_to(mesh.control);
    for (const PatchRange& range : patches.ranges()) {
      const Eigen::VectorXd together = jets_of(patches, range, kThirdOrderCount, 1);
      const Eigen::Index size = together.size() / range.count;
      for (int p = 0; p < range.count; ++p) {
        const Eigen::VectorXd alone = jets_of(patches, {range.set, range.first + p, 1}, kThirdOrderCount, 1);
        EXPECT_LT((together.segment(p * size, size) - alone).norm(), 1e-14 * alone.norm());
      }
    }
  }
}

TEST(PatchEvaluator, visits_each_patch_once) {
  const Refined mesh = rough(trapezohedron(6), 2, 0.03, 1);
  const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
  std::vector<int> next(layout.sets().size(), 0);
  const PatchEvaluator patches = by_tables(layout);
  for (const PatchRange& range : patches.ranges()) {
    EXPECT_EQ(range.first, next[range.set]);
    next[range.set] += range.count;
  }
  for (std::size_t s = 0; s < next.size(); ++s) EXPECT_EQ(next[s], layout.sets()[s].count());
}

TEST(PatchEvaluator, starts_with_the_position_or_any_other_derivative) {
  const Refined mesh = rough(trapezohedron(5), 2, 0.03, 2);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    PatchEvaluator patches = by_tables(layout);
    patches.move_to(mesh.control);
    for (int set = 0; set < patches.set_count(); ++set) {
      const int samples = patches.basis(set).samples();
      const auto matrix = [&](int derivatives, int from) -> Eigen::MatrixXd {
        return jets_of(patches, {set, 0, 1}, derivatives, from).reshaped(derivatives * samples, 3);
      };
      const Eigen::MatrixXd all = matrix(kDerivativeCount, 0);
      for (const int from : {1, 3}) {
        const int derivatives = kSecondOrderCount;
        EXPECT_LT((matrix(derivatives, from) - all.middleRows(from * samples, derivatives * samples)).norm(),
                  1e-14 * all.norm());
      }
      const Points& points = patches.points();
      const PatchSet& patch = layout.sets()[set];
      Points local(patch.columns, 3);
      for (int i = 0; i < patch.columns; ++i) local.row(i) = points.row(patch.points[i]);
      const Sample first = samples_of(patch.kind, kFewPoints).front();
      Eigen::RowVector3d position = patch_basis(patch.kind, first.u, first.v).row(0) * local;
      if (patch.kind.shape == CapShape::kFlat) {
        const Vector3 n = patches.normal(set, 0);
        position -= (patch_flattening(patch.kind, first.u, first.v).row(0) * local).dot(n) * n.transpose();
      }
      EXPECT_LT((all.row(0) - position).norm(), 1e-14);
    }
  }
}

TEST(PatchEvaluator, pulls_back_by_the_transpose_of_the_derivative) {
  const Refined mesh = rough(trapezohedron(5), 2, 0.03, 3);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    PatchEvaluator patches = by_tables(layout);
    for (int set = 0; set < patches.set_count(); ++set) {
      const PatchRange range{set, 0, std::min(3, layout.sets()[set].count())};
      Random random(set);
      const Points v = random.points(mesh.control.rows());
      const auto at = [&](double t) {
        patches.move_to(mesh.control + t * v);
        return jets_of(patches, range, kSecondOrderCount, 1);
      };
      // Linear, but for the normals of flat caps: a difference quotient of order 4.
      const double h = cap == CapKind::kFlat ? 1e-3 : 1;
      const Eigen::VectorXd jv = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
      const Eigen::VectorXd w = random.matrix<Eigen::VectorXd>(at(0).size(), 1);
      PatchMemory memory;
      RangeAdjoint pulled_back;
      PatchAdjoint sum;
      patches.jets(range, kSecondOrderCount, memory);
      patches.pull_back(w.data(), kSecondOrderCount, memory, pulled_back);
      patches.clear(sum);
      patches.add(range, pulled_back, sum);
      Points gradient;
      patches.finish(sum, gradient);
      ASSERT_EQ(gradient.rows(), mesh.control.rows());
      const double tolerance = cap == CapKind::kFlat ? 1e-9 : 1e-13;
      EXPECT_NEAR(gradient.cwiseProduct(v).sum(), jv.dot(w), tolerance * jv.norm() * w.norm());
    }
  }
}

}  // namespace
}  // namespace umbilic::test
