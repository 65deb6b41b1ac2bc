// SPDX-License-Identifier: MIT
/// \file
/// Thin cages, whose rims no sample sees, against the spheres and tori that they are to become.
#include "driver/thickness.h"

#include <gtest/gtest.h>

#include <numbers>

#include "driver/gauss_bonnet.h"
#include "driver/run.h"
#include "mesh/rough_cages.h"
#include "mesh/symmetry.h"

namespace umbilic::test {
namespace {

using std::numbers::pi;

Cage scaled_cube(double x, double y, double z) {
  Cage cage = cube();
  cage.vertices = (cage.vertices * Vector3(x, y, z).asDiagonal()).eval();
  return cage;
}

umbilic::Run thin_run(const Cage& cage, int iterations = 1000) {
  RunOptions options;
  options.weights = {1, 0, 0, 0, 0, 0};
  options.max_iterations = iterations;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(100)) {
  }
  return run;
}

TEST(Thickness, lets_plates_and_boxes_of_any_proportions_become_spheres) {
  // A cube's minimizer at level 2 is 9e-5 above 8 pi.
  for (const Vector3& edges :
       {Vector3(1, 1, 0.003), Vector3(1, 1, 1e-6), Vector3(1000, 1, 1), Vector3(1000, 1, 0.001)}) {
    const umbilic::Run run = thin_run(scaled_cube(edges[0], edges[1], edges[2]));
    const LevelReport& last = run.levels().back();
    EXPECT_TRUE(run.levels().front().thickened) << edges.transpose();
    EXPECT_EQ(name_of(last.stop), "converged") << edges.transpose();
    EXPECT_GT(last.energy_reported, 8 * pi) << edges.transpose();
    EXPECT_LT(last.energy_reported, 8 * pi * (1 + 1e-4)) << edges.transpose();
    EXPECT_NEAR(run.energies().gaussian, 4 * pi, 1e-6);
  }
}

TEST(Thickness, is_not_given_to_surfaces_whose_curvature_the_samples_see) {
  const umbilic::Run run = thin_run(scaled_cube(1, 1, 0.05), 3);
  for (const LevelReport& level : run.levels()) EXPECT_FALSE(level.thickened);
}

TEST(Thickness, is_not_given_without_iterations_so_that_the_surface_is_reported_as_it_is) {
  const Cage plate = scaled_cube(1, 1, 0.003);
  const umbilic::Run run = thin_run(plate, 0);
  const double expected = evaluate(plate, CapKind::kSmooth, 0)->energies.functionals[kBending];
  EXPECT_NEAR(run.levels()[0].energy_reported, expected, 1e-12 * expected);
  EXPECT_FALSE(run.levels()[0].thickened);
  EXPECT_FALSE(run.levels()[0].credible) << "it hides curvature";
}

TEST(Thickness, commutes_with_rotations_and_keeps_means) {
  const Cage plate = scaled_cube(1, 0.7, 1e-3);
  const MeshComponents components = find_components(PolygonMesh(plate));
  const Points turned = plate.vertices * some_rotation().transpose();
  const Points once = thickened(turned, components, 10);
  const Points other = thickened(plate.vertices, components, 10) * some_rotation().transpose();
  // The squares of deviations 1000 times apart have 10 digits in common.
  EXPECT_LT((once - other).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT(once.colwise().mean().norm(), 1e-13);
}

TEST(Thickness, ends_where_standard_deviations_are_as_far_apart_as_allowed) {
  const Cage plate = scaled_cube(1, 0.5, 1e-4);
  const MeshComponents components = find_components(PolygonMesh(plate));
  const Points points = thickened(plate.vertices, components, 10);
  const Eigen::RowVector3d extents = points.colwise().maxCoeff();
  EXPECT_NEAR(extents[0], 1, 1e-14);
  EXPECT_NEAR(extents[1], 0.5, 1e-14);
  EXPECT_NEAR(extents[2], 0.1, 1e-13);
}

TEST(Thickness, of_none_stays_none) {
  Cage flat = scaled_cube(1, 1, 0);
  flat.vertices.topRows(4) *= 0.9;
  const MeshComponents components = find_components(PolygonMesh(flat));
  EXPECT_EQ(thickened(flat.vertices, components, 3), flat.vertices);
}

}  // namespace
}  // namespace umbilic::test
