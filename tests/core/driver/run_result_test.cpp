// SPDX-License-Identifier: MIT
/// \file
/// What a run says of its result at any time: its symmetry, the limit of its levels, its certificate.
#include <gtest/gtest.h>

#include <cmath>

#include "cage/generate.h"
#include "driver/extrapolate.h"
#include "driver/run.h"
#include "mesh/coordinates.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

RunOptions bending(int first, int last) {
  RunOptions options;
  options.weights = {1, 0, 0, 0, 0, 0};
  options.first_level = first;
  options.last_level = last;
  return options;
}

umbilic::Run started(const Cage& cage, const RunOptions& options) { return *umbilic::Run::create(cage, options); }

void finish(umbilic::Run& run) {
  while (!run.step(100)) {
  }
}

TEST(Run, keeps_the_symmetry_of_its_cage_on_every_level_unless_told_not_to) {
  for (const char* name : {"two-4", "tetrahedron-frame", "torus"}) {
    const Cage cage = *generate_cage(name);
    const SymmetryGroup expected = find_symmetry(PolygonMesh(cage), cage.vertices);
    umbilic::Run run = started(cage, bending(0, 1));
    EXPECT_EQ(run.group().name, expected.name);
    finish(run);
    EXPECT_EQ(run.group().order, expected.order);
    const Cage result = run.control_mesh();
    EXPECT_EQ(find_symmetry(PolygonMesh(result), result.vertices).name, expected.name);
    RunOptions free = bending(0, 1);
    free.symmetry = false;
    EXPECT_EQ(started(cage, free).group().name, "C1");
    EXPECT_EQ(started(cage, free).group().order, 1);
  }
}

TEST(Run, reports_as_unknowns_what_is_moved) {
  const Cage cage = *generate_cage("two-3", {.family = FrameFamily::kHub});
  RunOptions options = bending(0, 2);
  options.max_iterations = 0;
  const SymmetryGroup group = find_symmetry(PolygonMesh(cage), cage.vertices);
  umbilic::Run run = started(cage, options);
  finish(run);
  EXPECT_EQ(run.levels()[0].unknowns, Coordinates(PolygonMesh(cage), group).count());
  options.symmetry = false;
  umbilic::Run free = started(cage, options);
  finish(free);
  for (const LevelReport& level : free.levels()) {
    EXPECT_EQ(level.unknowns, 3 * refined(cage, level.level).mesh.vertex_count());
  }
}

TEST(Run, makes_a_cage_that_is_symmetric_to_four_decimals_exactly_symmetric) {
  Cage cage = *generate_cage("cube");
  cage.vertices += 2e-5 * Random(1).points(8);
  umbilic::Run run = started(cage, bending(1, 1));
  EXPECT_EQ(run.group().name, "Oh");
  const Points start = run.control_mesh().vertices;
  const Eigen::VectorXd radii = (start.rowwise() - start.colwise().mean()).rowwise().norm();
  const double largest = radii.maxCoeff();
  EXPECT_EQ((radii.array() > largest * (1 - 1e-14)).count(), 12) << "one orbit, that of the edges' points";
  EXPECT_EQ((radii.array() > largest * (1 - 1e-3)).count(), 12);
}

TEST(Run, builds_the_metric_that_was_chosen) {
  const std::pair<MetricChoice, const char*> choices[] = {{MetricChoice::kAutomatic, "hessian"},
                                                          {MetricChoice::kHessian, "hessian"},
                                                          {MetricChoice::kNewton, "newton"},
                                                          {MetricChoice::kSobolev, "sobolev"},
                                                          {MetricChoice::kIdentity, "identity"}};
  for (const auto& [metric, name] : choices) {
    RunOptions options = bending(0, 0);
    options.metric = metric;
    options.max_iterations = 12;
    umbilic::Run run = started(*generate_cage("two-3"), options);
    finish(run);
    EXPECT_EQ(name_of(run.levels()[0].metric), name);
    const int most = metric == MetricChoice::kIdentity ? 0 : metric == MetricChoice::kNewton ? 13 : 2;
    EXPECT_LE(run.levels()[0].metrics, most);
    EXPECT_GE(run.levels()[0].metrics, most > 0 ? 1 : 0);
    // The Hessian of the start is not positive definite.
    EXPECT_EQ(run.levels()[0].factorizations > run.levels()[0].metrics, name == std::string("hessian")) << name;
    EXPECT_GE(run.levels()[0].factorizations, run.levels()[0].metrics) << name;
  }
}

TEST(Run, reports_what_a_level_could_still_gain_which_is_below_the_tolerance_where_it_has_converged) {
  const RunOptions options = bending(0, 1);
  umbilic::Run run = started(*generate_cage("two-3"), options);
  finish(run);
  for (const LevelReport& level : run.levels()) {
    ASSERT_EQ(level.stop, StopReason::kConverged);
    EXPECT_LE(level.predicted_decrease, options.tolerance * level.energy);
  }
  RunOptions none = options;
  none.max_iterations = 0;
  umbilic::Run still = started(*generate_cage("two-3"), none);
  finish(still);
  EXPECT_TRUE(std::isnan(still.levels()[0].predicted_decrease)) << "before the first iteration";
}

TEST(Run, extrapolates_the_evaluable_levels_that_have_ended) {
  umbilic::Run run = started(*generate_cage("two-4", {.family = FrameFamily::kHub}), bending(0, 3));
  EXPECT_EQ(name_of(run.limit().status), "too_few_levels");
  EXPECT_TRUE(std::isnan(run.limit().energy));
  while (!run.step(1)) {
    if (run.levels().size() < 4) {
      EXPECT_EQ(name_of(run.limit().status), "too_few_levels");
    }
  }
  ASSERT_EQ(run.levels().size(), 4u);
  EXPECT_FALSE(run.levels()[0].evaluable) << "it prepares the next, and is none of the three";
  std::vector<LevelEnergy> energies;
  for (int i = 1; i < 4; ++i) energies.push_back({run.levels()[i].energy_reported, 0, 1, true});
  const LimitReport expected = extrapolate(energies, false), limit = run.limit();
  EXPECT_EQ(name_of(limit.status), "converging");
  EXPECT_EQ(limit.energy, expected.energy);
  EXPECT_EQ(limit.order, expected.order);
  const double tolerance = 1e-6 * energies.back().energy;
  EXPECT_GT(limit.error, expected.error + tolerance);
  EXPECT_LT(limit.error, 1.05 * expected.error + 3 * tolerance) << "the quadrature's error is small";
}

TEST(Run, has_no_limit_where_a_level_was_cut_short) {
  RunOptions options = bending(0, 2);
  options.max_iterations = 3;
  umbilic::Run run = started(*generate_cage("two-3"), options);
  finish(run);
  EXPECT_EQ(name_of(run.limit().status), "not_minimized");
}

TEST(Run, certifies_its_best_surface_at_any_time) {
  umbilic::Run run = started(*generate_cage("torus"), bending(2, 2));
  const auto negative = [&] {
    Certificate certificate = *run.certify();
    while (!certificate.step()) {
    }
    EXPECT_EQ(certificate.report()->unknowns, run.control_mesh().vertices.size());
    return certificate.report()->negative;
  };
  const int before = negative();
  run.step(10);
  const Points control = run.control_mesh().vertices;
  negative();
  EXPECT_EQ(run.control_mesh().vertices, control) << "a certificate changes nothing";
  finish(run);
  EXPECT_GT(before, 0);
  EXPECT_EQ(negative(), 0);
  RunOptions flat = bending(0, 0);
  flat.cap = CapKind::kFlat;
  EXPECT_FALSE(started(*generate_cage("two-3"), flat).certify().ok());
}

}  // namespace
}  // namespace umbilic::test
