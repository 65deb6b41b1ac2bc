// SPDX-License-Identifier: MIT
/// \file
/// Energies of surfaces with boundary: closed forms, Gauss & Bonnet, gradients, symmetry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "energy/single_weight.h"
#include "energy/surface_energy.h"
#include "mesh/boundary.h"
#include "mesh/coordinates.h"
#include "mesh/hierarchy.h"
#include "mesh/open_cages.h"
#include "surface/boundary_turning.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

constexpr double kPi = std::numbers::pi;

Refined evaluable(const Cage& cage, int extra = 0) {
  const PolygonMesh mesh(cage);
  return refined(mesh, cage.vertices, required_level(mesh).value() + extra);
}

std::map<std::string, Cage> all_open_cages() {
  std::map<std::string, Cage> cages = tame_open_cages();
  cages.merge(wild_open_cages());
  cages.merge(holed_cages());
  return cages;
}

/// A catenoid of waist 1 between z = -a and a as a B-spline tube of n x m quads, m even, whose ghosts lie on the
/// catenoid continued: c = f - f'' / 6 by differences in both directions, which is within O(h^4) of the surface.
Refined catenoid(double a, int n, int m) {
  Cage cage = tube(n, m + 2);
  for (int i = 0; i < n; ++i) {
    cage.holes.push_back(i);
    cage.holes.push_back((m + 1) * n + i);
  }
  std::sort(cage.holes.begin(), cage.holes.end());
  const double around = (8 - 2 * std::cos(2 * kPi / n)) / 6;
  const auto z = [&](int j) { return 2 * a * (j - 1) / m - a; };
  for (int j = 0; j <= m + 2; ++j) {
    const double radius = around * (8 * std::cosh(z(j)) - std::cosh(z(j - 1)) - std::cosh(z(j + 1))) / 6;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * kPi * i / n;
      cage.vertices.row(j * n + i) << radius * std::cos(angle), radius * std::sin(angle), z(j);
    }
  }
  return {PolygonMesh(cage), cage.vertices};
}

TEST(OpenEnergy, of_a_catenoid_converges_to_its_closed_forms_like_h_to_the_4) {
  // Bending 8 pi tanh a; mvs_cross with its area from the integral of |grad k|^2 of k = 1 / cosh^2.
  for (const auto& [a, mvs_cross] : {std::pair{0.5, 19.703131}, {1.0, 170.609323}}) {
    double bending_error = 0, cross_error = 0;
    for (const int n : {16, 32}) {
      const Refined mesh = catenoid(a, n, n / 4 * (a < 1 ? 1 : 2));
      ASSERT_EQ(required_level(mesh.mesh).value(), 0);
      const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
      const JetEvaluator jets(layout, {6, 6, 2});
      const SurfaceIntegrals integrals = surface_integrals(jets, mesh.control);
      const double bending = std::abs(integrals.functionals[kBending] / (8 * kPi * std::tanh(a)) - 1);
      const double cross = std::abs(integrals.functionals[kMvsCross] / mvs_cross - 1);
      if (n == 32) {
        EXPECT_LT(bending, bending_error / 10);
        EXPECT_LT(cross, cross_error / 3);  // third derivatives of cubic splines: h^2
        EXPECT_LT(bending, 1e-4);
        EXPECT_LT(cross, 2e-2);
      }
      bending_error = bending;
      cross_error = cross;
    }
  }
}

double gauss_bonnet_sum(const Refined& mesh, CapKind cap, const QuadratureRule& rule, int points) {
  const PatchLayout layout(mesh.mesh, cap);
  const JetEvaluator jets(layout, rule);
  return surface_integrals(jets, mesh.control).gaussian +
         boundary_turning(mesh.mesh, layout, layout.extend(mesh.control), points);
}

TEST(OpenEnergy, gaussian_curvature_and_turning_of_the_boundary_sum_to_2_pi_chi) {
  // By the reporting rule, whose error is 1.8e-5 at most here.
  for (const auto& [name, cage] : all_open_cages()) {
    SCOPED_TRACE(name);
    const Refined mesh = evaluable(cage);
    const double expected = 2 * kPi * mesh.mesh.euler_characteristic();
    EXPECT_NEAR(gauss_bonnet_sum(mesh, CapKind::kSmooth, {7, 8, 4}, 8), expected, 3e-5);
  }
}

TEST(OpenEnergySlow, gaussian_curvature_and_turning_of_the_boundary_tend_to_2_pi_chi) {
  const std::map<std::string, Cage> cages = all_open_cages();
  for (const char* name : {"L", "fan of 5", "disc of 7", "prism without an end"}) {  // one of each kind
    SCOPED_TRACE(name);
    const Refined mesh = evaluable(cages.at(name));
    const double expected = 2 * kPi * mesh.mesh.euler_characteristic();
    EXPECT_NEAR(gauss_bonnet_sum(mesh, CapKind::kSmooth, {10, 12, 6}, 12), expected, 1e-6);
  }
}

TEST(OpenEnergy, of_a_flat_polygon_turns_by_its_corners) {
  // A flat sheet: no curvature, four right angles.
  Cage cage = sheet(2, 3);
  cage.vertices.col(2).setZero();
  const Refined mesh = evaluable(cage);
  const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
  EXPECT_NEAR(boundary_turning(mesh.mesh, layout, layout.extend(mesh.control)), 2 * kPi, 1e-12);
}

TEST(OpenEnergy, gradient_equals_difference_quotients_by_all_control_points_ghosts_too) {
  for (const std::string name :
       {"sheet", "tube", "open cube", "disc of 7", "fan of 3", "fan of 6", "L", "hexagon", "prism without an end"}) {
    SCOPED_TRACE(name);
    Refined mesh = evaluable(all_open_cages().at(name));
    const double size = mesh.control.rowwise().norm().maxCoeff();
    mesh.control += 0.01 * size * Random(6).points(mesh.control.rows());
    const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
    const JetEvaluator jets(layout, kFewPoints);
    for (const int functional : {kBending, kMvsCross}) {
      const SurfaceEnergy energy(jets, only(functional));
      Points gradient;
      energy.evaluate(mesh.control, &gradient);
      const Points direction = Random(9).points(mesh.control.rows());
      const auto at = [&](double t) { return energy.evaluate(mesh.control + t * direction, nullptr).energy; };
      const double slope = gradient.cwiseProduct(direction).sum();
      double mismatch = 1;  // by the best step, since none suits all energies
      for (const double step : {1e-5, 1e-6, 1e-7}) {
        const double h = step * size, quotient = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
        mismatch = std::min(mismatch, std::abs(quotient - slope) / gradient.norm());
      }
      EXPECT_LT(mismatch, 1e-7);
    }
  }
}

/// With heights that keep the symmetry of the plan.
Cage arched(Cage cage) {
  cage.vertices.col(2) = -0.3 * cage.vertices.leftCols(2).rowwise().squaredNorm();
  return cage;
}

TEST(OpenEnergy, by_one_patch_for_each_orbit_equals_that_by_all) {
  std::map<std::string, Cage> cages{{"tube", tube(6, 2)},
                                    {"half disc", arched(half_disc(4))},
                                    {"disc", arched(disc(5))},
                                    {"open cube", without(cube(), {0})},
                                    {"hexagon", polygon(6)},
                                    {"holed cube", with_holes(cube(), {0, 1})},
                                    {"two", joined(tube(4, 1), tube(4, 1))}};
  for (const auto& [name, cage] : cages) {
    SCOPED_TRACE(name);
    Refined mesh{PolygonMesh(cage), cage.vertices};
    SymmetryGroup group = find_symmetry(mesh.mesh, mesh.control);
    EXPECT_GT(group.order, 1);
    const int levels = std::max(required_level(mesh.mesh).value(), 1);
    for (int level = 0; level < levels; ++level) {
      group = umbilic::refined(group, mesh.mesh);
      mesh = refined(mesh.mesh, mesh.control, 1);
    }
    const Coordinates coordinates(mesh.mesh, group);
    const Points symmetric = coordinates.control(coordinates.unknowns(mesh.control));
    EXPECT_LT((symmetric - mesh.control).norm(), 1e-12) << "the map of ghosts is that of the group";
    const Eigen::VectorXd start = coordinates.unknowns(mesh.control);
    mesh.control = coordinates.control(start + 0.01 * Random(3).matrix<Eigen::VectorXd>(start.size(), 1));
    const PatchLayout whole(mesh.mesh, CapKind::kSmooth);
    const PatchLayout part(mesh.mesh, CapKind::kSmooth, face_orbits(mesh.mesh, group));
    EXPECT_LE(part.patch_count(), whole.patch_count() / 2 + 1);
    const JetEvaluator all(whole, kFewPoints), one_of_each(part, kFewPoints);
    for (const int functional : {kBending, kMvsCross}) {
      Points gradient, part_of_gradient;
      const double expected = SurfaceEnergy(all, only(functional)).evaluate(mesh.control, &gradient).energy;
      const double found =
          SurfaceEnergy(one_of_each, only(functional)).evaluate(mesh.control, &part_of_gradient).energy;
      EXPECT_NEAR(found / expected, 1, 1e-11);
      const Eigen::VectorXd reduced = coordinates.pull_back(gradient);
      EXPECT_LT((coordinates.pull_back(part_of_gradient) - reduced).norm(), 1e-10 * reduced.norm());
    }
    EXPECT_NEAR(boundary_turning(mesh.mesh, part, part.extend(mesh.control)),
                boundary_turning(mesh.mesh, whole, whole.extend(mesh.control)), 1e-10);
  }
}

}  // namespace
}  // namespace umbilic::test
