// SPDX-License-Identifier: MIT
/// \file
/// Parts of a sphere and of a torus, found from the position, slope and curvature at their boundaries alone; and the
/// energies of given open surfaces.
///
/// The parts are bands without extraordinary vertices: a cap leaves an error of its own, which a finer boundary does
/// not remove.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

#include "cage/generate.h"
#include "driver/run.h"

namespace umbilic {
namespace {

/// A curve in the half-plane of a radius r and a height z with its first two derivatives: (r, z), (r', z'), (r'', z'').
struct Profile {
  std::function<Eigen::Matrix<double, 3, 2>(double)> at;
  double begin, end;
};

Profile circle(double center, double radius, double begin, double end) {
  const auto at = [=](double t) {
    const double c = radius * std::cos(t), s = radius * std::sin(t);
    return Eigen::Matrix<double, 3, 2>{{center + c, s}, {-s, c}, {-c, -s}};
  };
  return {at, begin, end};
}

/// A band of the surface of revolution of n x m quads between rings of holes, without extraordinary vertices. The three
/// rows at each boundary have the exact position, slope and curvature across it; around, where these are circles, at
/// the knots of their splines. The other rows are on the surface, and moved at random by up to `disturbance`.
Cage band(const Profile& profile, int n, int m, double disturbance) {
  const double step = (profile.end - profile.begin) / m;
  const double swell = 3 / (2 + std::cos(2 * std::numbers::pi / n));  // of a ring of control points, beyond its circle
  std::mt19937 random(7);
  Cage cage;
  cage.vertices.resize((m + 3) * n, 3);
  for (int j = -1; j <= m + 1; ++j) {
    const bool first = j <= 1, boundary = first || j >= m - 1;
    const int k = first ? j : j - m;
    const Eigen::Matrix<double, 3, 2> p =
        profile.at(boundary ? (first ? profile.begin : profile.end) : profile.begin + j * step);
    Eigen::RowVector2d row = p.row(0);  // of C + k D + (1/2 k^2 - 1/6) E
    if (boundary) row += k * step * p.row(1) + (k * k / 2. - 1 / 6.) * step * step * p.row(2);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      Vector3 x(swell * row[0] * std::cos(angle), swell * row[0] * std::sin(angle), row[1]);
      for (int c = 0; c < 3 && !boundary; ++c) x[c] += disturbance * (2. * random() / std::mt19937::max() - 1);
      cage.vertices.row((j + 1) * n + i) = x;
    }
  }
  const auto add_ring = [&](int j) {
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      cage.faces.push_back({j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i});
    }
  };
  for (int j = 1; j <= m; ++j) add_ring(j);
  for (const int j : {0, m + 1}) {
    for (int i = 0; i < n; ++i) cage.holes.push_back(static_cast<int>(cage.faces.size()) + i);
    add_ring(j);
  }
  return cage;
}

Run with_curvature_held(const Cage& cage, const char* functional, int last_level) {
  RunOptions options;
  options.weights = *weights_of(functional);
  options.last_level = last_level;
  Constraints constraints;
  constraints.boundary = BoundaryConditions{BoundaryCondition::kCurvature, {}};
  Run run = *Run::create(cage, options, constraints);
  while (!run.step(1000)) {
  }
  return run;
}

/// The surface has no energy of this functional. On the level of the cage, a disturbed band falls as far as one that is
/// not. Over the levels, where the latter has few unknowns, the mesh's error falls like h^2 to what the
/// boundary's splines are off by.
double floor_of(const Profile& profile, int n, int m, Functional functional) {
  const char* const name = kFunctionalNames[functional].data();
  const Cage disturbed = band(profile, n, m, 0.03);
  const Run run = with_curvature_held(band(profile, n, m, 0), name, 3), again = with_curvature_held(disturbed, name, 0);
  EXPECT_GT(run.group().order, 2 * n - 1);
  EXPECT_EQ(again.group().order, 1);
  EXPECT_EQ(again.result().stop, StopReason::kConverged);
  EXPECT_LT(again.result().energy_reported, 1.01 * run.levels()[0].energy_reported);
  EXPECT_LT(again.result().energy_reported,
            0.05 * evaluate(disturbed, CapKind::kSmooth, 0)->energies.functionals[functional]);
  const double last = run.levels()[3].energy_reported, before = run.levels()[2].energy_reported;
  EXPECT_LT(last, before);
  return last - (before - last) / 3;
}

void expect_floors(const Profile& profile, int n, int m, Functional functional) {
  const double coarse = floor_of(profile, n, m, functional), fine = floor_of(profile, 2 * n, 2 * m, functional);
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, coarse / 6);
}

TEST(CurvatureDataSlow, of_a_band_of_a_sphere_give_it_back_for_mvs_cross) {
  expect_floors(circle(0, 1, -0.4, 0.9), 8, 4, kMvsCross);
}

TEST(CurvatureDataSlow, of_a_band_of_a_torus_give_it_back_for_mvs) {
  expect_floors(circle(2, 1, -0.5, 1.3), 16, 4, kMvs);
}

/// Nothing is minimized. Splines that are h^4 off the surface have energies of third order that are h^2 off its own.
TEST(GivenSurfaces, catenoids_have_their_mvs_cross_to_1e_3) {
  for (const auto& [half_height, expected] : {std::pair{0.5, 19.703131}, {1., 170.609323}}) {
    double before = 1;
    for (const int n : {32, 64, 128}) {
      CageOptions options;
      options.height = 2 * half_height;
      options.major_segments = n;
      options.minor_segments = n / 2;
      const Cage cage = *generate_cage("catenoid", options);
      const double energy = evaluate(cage, CapKind::kSmooth, 0)->energies.functionals[kMvsCross];
      const double error = std::abs(energy / expected - 1);
      EXPECT_LT(error, before / 3.9) << n;
      before = error;
    }
    EXPECT_LT(before, 1e-3) << half_height;
  }
}

}  // namespace
}  // namespace umbilic
