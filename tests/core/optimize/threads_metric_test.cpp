// SPDX-License-Identifier: MIT
/// \file
/// Second derivatives and metrics have the same bits from any number of threads.
#include <gtest/gtest.h>

#include "base/with_threads.h"
#include "mesh/rough_cages.h"
#include "mesh/symmetry.h"
#include "optimize/hessian_metric.h"
#include "optimize/sobolev.h"
#include "surface/all_caps.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

template <class Parts>
void complete(Parts& parts, const Points& control) {
  parts.begin(control);
  while (!parts.advance()) {
  }
}

Eigen::VectorXd values_of(const Eigen::SparseMatrix<double>& matrix) {
  return Eigen::Map<const Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros());
}

/// The assembled matrices, and what each metric makes of a gradient.
std::vector<Eigen::VectorXd> computed(const PatchLayout& layout, const Unknowns& unknowns, const Points& control,
                                      const ClosenessTerm* closeness) {
  const Weights weights{1, 0, 0, 1};
  std::vector<Eigen::VectorXd> results;
  HessianAssembly assembly(layout, unknowns, weights, kFewPoints, kUmbilicEta, {}, closeness);
  complete(assembly, control);
  results.push_back(values_of(assembly.combine(1, 0)));
  results.push_back(values_of(assembly.combine(0, 1)));
  results.emplace_back(assembly.factors().reshaped());
  const Eigen::VectorXd gradient = Eigen::VectorXd::LinSpaced(unknowns.count(), -1, 1);
  for (const bool newton : {false, true}) {
    HessianMetric metric(layout, unknowns, weights, kFewPoints, {}, {}, closeness, newton);
    complete(metric, control);
    results.push_back(metric.solve(gradient));
  }
  const JetEvaluator jets(layout, kFewPoints);
  const SurfaceEnergy energy(jets, weights);
  SobolevMetric sobolev(energy, unknowns, {}, closeness);
  complete(sobolev, control);
  results.push_back(sobolev.solve(gradient));
  return results;
}

void expect_same_bits(const PatchLayout& layout, const Unknowns& unknowns, const Points& control,
                      const ClosenessTerm* closeness = nullptr) {
  std::vector<Eigen::VectorXd> expected;
  for (const int threads : kThreadCounts) {
    SCOPED_TRACE(threads);
    const WithThreads with(threads);
    const std::vector<Eigen::VectorXd> results = computed(layout, unknowns, control, closeness);
    if (threads == 1) expected = results;
    for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(results[i], expected[i]) << "result " << i;
  }
}

TEST(MetricsSlow, have_the_same_bits_from_any_number_of_threads_with_each_cap) {
  const Refined mesh = rough(trapezohedron(5), 2, 0.03, 4);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    expect_same_bits(layout, Unknowns(Coordinates(mesh.mesh.vertex_count())), mesh.control);
  }
}

TEST(MetricsSlow, have_the_same_bits_from_any_number_of_threads_pulled_to_another_surface) {
  const Refined mesh = rough(trapezohedron(5), 2, 0.03, 4);
  const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
  const ClosenessTerm closeness(layout, 1.01 * mesh.control, 3);
  expect_same_bits(layout, Unknowns(Coordinates(mesh.mesh.vertex_count())), mesh.control, &closeness);
}

TEST(Metrics, of_symmetric_surfaces_have_the_same_bits_from_any_number_of_threads) {
  const Refined mesh = refined(trapezohedron(5), 3);
  const SymmetryGroup group = find_symmetry(mesh.mesh, mesh.control);
  ASSERT_GT(group.order, 1);
  const PatchLayout layout(mesh.mesh, CapKind::kSmooth, face_orbits(mesh.mesh, group));
  expect_same_bits(layout, Unknowns(Coordinates(mesh.mesh, group)), mesh.control);
}

}  // namespace
}  // namespace umbilic::test
