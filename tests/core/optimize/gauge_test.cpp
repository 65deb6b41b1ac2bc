// SPDX-License-Identifier: MIT
/// \file
/// The gauge: energies do not change along it, and its directions are the velocities of the maps that they stand for.
#include "optimize/gauge.h"

#include <gtest/gtest.h>

#include "energy/single_weight.h"
#include "energy/surface_energy.h"
#include "mesh/rough_cages.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

constexpr Gauge kEverything{true, true, true, true};

/// A cube with moved corners, smooth and without symmetry.
Refined skew_cube(int level) {
  Cage cage = cube();
  cage.vertices += 0.3 * Random(5).points(cage.vertices.rows());
  return refined(cage, level);
}

/// The largest derivative of the energy along a direction, relative to the energy: of a surface, not of its mesh.
double largest_slope(const Refined& mesh, const Weights& weights, const Eigen::MatrixXd& directions) {
  const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
  const JetEvaluator jets(layout, kFewPoints);
  Points gradient;
  const double energy = SurfaceEnergy(jets, weights).evaluate(mesh.control, &gradient).energy;
  return (directions.transpose() * gradient.reshaped<Eigen::RowMajor>()).cwiseAbs().maxCoeff() / energy;
}

TEST(Gauge, of_every_functional_holds_the_similarities_along_which_its_gradient_vanishes) {
  const Refined mesh = skew_cube(1);
  for (int f = 0; f < kFunctionalCount; ++f) {
    Gauge similarities = gauge_of(only(f));
    similarities.conformal = false;
    EXPECT_EQ(similarities.dimension(), 7);
    const Eigen::MatrixXd directions = gauge_directions(similarities, mesh.control);
    ASSERT_EQ(directions.cols(), 7);
    EXPECT_LT(largest_slope(mesh, only(f), directions), 1e-10) << kFunctionalNames[f];  // round-off of many patches
  }
}

TEST(Gauge, holds_special_conformal_maps_where_no_functional_of_third_order_has_a_weight) {
  const Gauge conformal{false, false, false, true};
  for (int f = 0; f < kFunctionalCount; ++f) {
    EXPECT_EQ(gauge_of(only(f)).conformal, !is_third_order(f));
    const auto slope = [&](int level) {
      const Refined mesh = skew_cube(level);
      return largest_slope(mesh, only(f), gauge_directions(conformal, mesh.control));
    };
    // The discretization's error of bending falls with the level; the slope of the others belongs to the surface.
    const double coarse = slope(1), fine = slope(2);
    if (is_third_order(f)) {
      EXPECT_GT(fine, coarse / 2) << kFunctionalNames[f];
    } else {
      EXPECT_LT(fine, coarse / 2) << kFunctionalNames[f];
    }
  }
  EXPECT_FALSE(gauge_of({1, 0, 0, 1e-3, 0, 0}).conformal);
}

/// x -> x / |x|^2, then a small step along e, then back: to first order in the step the special conformal direction.
Points inverted(const Points& points) {
  Points result = points;
  for (Eigen::Index v = 0; v < points.rows(); ++v) result.row(v) /= points.row(v).squaredNorm();
  return result;
}

TEST(Gauge, directions_are_the_velocities_of_rigid_motions_scalings_and_inverted_translations) {
  Points x = Random(3).points(20);
  x.rowwise() -= x.colwise().mean();
  x /= x.rowwise().norm().maxCoeff();
  const Eigen::MatrixXd directions = gauge_directions(kEverything, x);
  ASSERT_EQ(directions.cols(), 10);
  const double h = 1e-5;
  const auto expect_velocity = [&](int column, const auto& moved) {
    const Eigen::VectorXd velocity = ((moved(h) - moved(-h)) / (2 * h)).eval().template reshaped<Eigen::RowMajor>();
    EXPECT_LT((directions.col(column) - velocity).norm(), 1e-7) << column;  // h^2 times derivatives of about 100
  };
  for (int i = 0; i < 3; ++i) {
    const Eigen::RowVector3d e = Eigen::RowVector3d::Unit(i);
    expect_velocity(i, [&](double t) -> Points { return x.rowwise() + t * e; });
    expect_velocity(3 + i, [&](double t) -> Points {
      return x * Eigen::AngleAxisd(t, Vector3::Unit(i)).toRotationMatrix().transpose();
    });
    expect_velocity(7 + i, [&](double t) -> Points { return inverted(inverted(x).rowwise() + t * e); });
  }
  expect_velocity(6, [&](double t) -> Points { return (1 + t) * x; });
  EXPECT_LT((scaling_direction(x) - x).norm(), 1e-14);
}

TEST(Gauge, loses_the_directions_that_are_held) {
  const Points x = Random(4).points(12);
  const Eigen::MatrixXd all = gauge_directions(kEverything, x);
  Gauge held = kEverything;
  held.rotations = false;
  const Eigen::MatrixXd rest = gauge_directions(held, x);
  ASSERT_EQ(rest.cols(), 7);
  EXPECT_EQ(rest.leftCols(3), all.leftCols(3));
  EXPECT_EQ(rest.rightCols(4), all.rightCols(4));
}

TEST(Gauge, orthonormal_columns_span_the_directions) {
  const Points x = Random(6).points(15);
  const Eigen::MatrixXd directions = gauge_directions(kEverything, x), q = orthonormal_gauge(kEverything, x);
  EXPECT_LT((q.transpose() * q - Eigen::MatrixXd::Identity(10, 10)).norm(), 1e-14);
  EXPECT_LT((q * (q.transpose() * directions) - directions).norm(), 1e-13 * directions.norm());
}

}  // namespace
}  // namespace umbilic::test
