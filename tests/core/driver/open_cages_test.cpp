// SPDX-License-Identifier: MIT
/// \file
/// Every kind of open cage with every condition at its boundary: it runs, or is refused with the place and the reason.
#include "mesh/open_cages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "driver/boundary_rows.h"
#include "driver/equations.h"
#include "driver/run.h"
#include "driver/surface.h"

namespace umbilic::test {
namespace {

Constraints with_condition(BoundaryCondition condition) {
  Constraints constraints;
  constraints.boundary = BoundaryConditions{condition, {}};
  return constraints;
}

using Conditions = testing::TestWithParam<BoundaryCondition>;

/// Of the equations, in units of the cage's size.
double largest_residual(const umbilic::Run& run, const Cage& cage, const Constraints& constraints) {
  const int level = run.state().level;
  const RefinedCage mesh = refine(*prepare(cage, level, true, constraints), level);
  const Points control =
      Coordinates(mesh.mesh, mesh.symmetry).control_from_orbits(mesh.placement.to_unit(run.orbit_points()));
  const LinearRows rows = equations_of(mesh).rows;
  if (rows.count() == 0) return 0;
  return (rows.matrix * Eigen::Map<const Eigen::VectorXd>(control.data(), control.size()) - rows.right)
      .cwiseAbs()
      .maxCoeff();
}

/// A few steps raise the energy only where a finer rule sees more of it, or a term makes the parametrization even; keep
/// the equations, and claim nothing of what is not finite.
void expect_a_sound_run(umbilic::Run run, const Cage& cage, const Constraints& constraints) {
  double energy = std::numeric_limits<double>::quiet_NaN();
  int rises = 0;
  while (!run.step(1)) {
    const double now = run.progress().energy;
    if (now > energy) ++rises;
    if (std::isfinite(now)) energy = now;
  }
  const LevelReport& result = run.result();
  if (result.parametrization_stages == 0) {
    EXPECT_LE(rises, result.quadrature);
  }
  EXPECT_TRUE(std::isfinite(result.energy)) << result.energy;
  EXPECT_TRUE(std::isfinite(result.energy_reported)) << result.energy_reported;
  EXPECT_GE(result.energy, 0);
  EXPECT_TRUE(result.evaluable);
  EXPECT_TRUE(result.stop == StopReason::kConverged || result.stop == StopReason::kMaxIterations ||
              result.stop == StopReason::kRoundOff || result.stop == StopReason::kLineSearchStalled)
      << name_of(result.stop);
  EXPECT_LE(largest_residual(run, cage, constraints), 1e-12);
  ASSERT_TRUE(run.constraints().has_value());
  EXPECT_TRUE(std::isfinite(run.constraints()->deviation));
}

RunOptions a_few_steps_of(const char* functional) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = 0;  // the first that can be evaluated
  options.max_iterations = 5;
  return options;
}

TEST_P(Conditions, let_open_cages_run_or_refuse_them_with_place_and_reason) {
  const Constraints constraints = with_condition(GetParam());
  int ran = 0, refused = 0;
  for (const auto& cages : {tame_open_cages(), wild_open_cages(), holed_cages()}) {
    for (const auto& [name, cage] : cages) {
      for (const char* functional : {"bending", "mvs_cross"}) {
        SCOPED_TRACE(name + ", " + functional);
        Result<umbilic::Run> run = umbilic::Run::create(cage, a_few_steps_of(functional), constraints);
        if (run) {
          ++ran;
          expect_a_sound_run(std::move(run).value(), cage, constraints);
        } else {
          ++refused;
          const std::string& words = run.error().message;
          EXPECT_EQ(
              words.find("constraints.boundary: the cage says nothing of the curvature across its boundary at vertex "),
              0u)
              << words;
        }
      }
    }
  }
  EXPECT_GE(ran + refused, 2 * 25);
  // Of the second derivative across it only holes tell.
  const auto holed = static_cast<int>(2 * holed_cages().size());
  EXPECT_EQ(refused, GetParam() == BoundaryCondition::kCurvature ? ran + refused - holed : 0);
}

/// A sheet, the surface over the 2 x 2 faces in its middle; around them so many rings of holes.
Cage ringed(int rings) {
  const int n = 2 + 2 * rings;
  std::vector<int> holes;
  for (int f = 0; f < n * n; ++f) {
    const int i = f % n - rings, j = f / n - rings;
    if (i < 0 || j < 0 || i > 1 || j > 1) holes.push_back(f);
  }
  Cage cage = with_holes(sheet(n, n), holes);
  for (int v = 0; v < (n + 1) * (n + 1); ++v) {
    const double x = v % (n + 1) - rings - 1, y = v / (n + 1) - rings - 1;
    cage.vertices.row(v) << x, y, 0.2 * std::sin(x) + 0.1 * x * y * y;
  }
  return cage;
}

TEST_P(Conditions, do_not_depend_on_holes_beyond_the_first_ring) {
  for (const char* functional : {"bending", "mvs_cross"}) {
    double energy = 0;
    for (const int rings : {1, 3}) {
      RunOptions options = a_few_steps_of(functional);
      options.last_level = 1;
      options.max_iterations = 100;
      options.tolerance = 1e-8;
      umbilic::Run run = *umbilic::Run::create(ringed(rings), options, with_condition(GetParam()));
      while (!run.step(100)) {
      }
      EXPECT_EQ(run.levels().size(), 2u);
      EXPECT_LE(run.levels()[0].unknowns, 3 * 25) << "the points of the surface and one ring";
      // The cages' sizes, and with them the optimizer's longest steps, differ.
      if (rings > 1) {
        EXPECT_NEAR(run.result().energy, energy, 1e-6 * (1 + energy));
      }
      energy = run.result().energy;
    }
  }
}

TEST(BoundaryConditions, that_hold_everything_are_said_to_and_have_no_negative_directions) {
  umbilic::Run run =
      *umbilic::Run::create(half_disc(5), a_few_steps_of("bending"), with_condition(BoundaryCondition::kTangent));
  while (!run.step(1)) {
  }
  EXPECT_EQ(run.result().unknowns, 0);
  EXPECT_EQ(run.constraints()->notes,
            std::vector<std::string>{"on level 1 nothing can move: what is held determines all control points"});
  Certificate certificate = *run.certify();
  EXPECT_TRUE(certificate.step());
  EXPECT_EQ(certificate.report()->negative, 0);
}

std::string condition_name(const testing::TestParamInfo<BoundaryCondition>& condition) {
  return std::string(name_of(condition.param));
}

/// The conditions that hold most; the others hold less, by the same rows or none.
INSTANTIATE_TEST_SUITE_P(At, Conditions, testing::Values(BoundaryCondition::kTangent, BoundaryCondition::kCurvature),
                         condition_name);
INSTANTIATE_TEST_SUITE_P(AtSlow, Conditions, testing::Values(BoundaryCondition::kFree, BoundaryCondition::kPosition),
                         condition_name);

}  // namespace
}  // namespace umbilic::test
