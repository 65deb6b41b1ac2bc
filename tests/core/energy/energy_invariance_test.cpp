// SPDX-License-Identifier: MIT
/// \file
/// Energies do not depend on where a cage stands, how large it is, and how it is numbered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "energy/surface_energy.h"
#include "mesh/rough_cages.h"
#include "reference/reference_cages.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

SurfaceIntegrals integrals(const Cage& cage, int level, CapKind cap) {
  const Refined mesh = refined(cage, level);
  const PatchLayout layout(mesh.mesh, cap);
  return surface_integrals(JetEvaluator(layout, {4, 5, 2}), mesh.control);
}

/// Expects the energies of `changed` to be those of the reference cage, areas to be `scale`^2 of it, and what is odd to
/// be `side` times it.
template <class Change>
void expect_invariance(const Change& change, double scale, double side = 1) {
  for (const auto& [name, level] : {std::pair{"torus", 0}, {"cube", 1}, {"cube", 2}, {"g2", 2}}) {
    const Cage cage = reference_cage(name);
    const Cage changed = change(cage);
    for (const CapKind cap : kAllCaps) {
      const SurfaceIntegrals a = integrals(cage, level, cap), b = integrals(changed, level, cap);
      // Third derivatives close to extraordinary vertices lose some digits.
      for (int f = 0; f < kFunctionalCount; ++f) {
        EXPECT_NEAR(b.functionals[f] / a.functionals[f], 1, 1e-10) << name << " " << kFunctionalNames[f];
      }
      for (int i = 0; i < kInvariantCount; ++i) {
        EXPECT_NEAR(b.invariants[i] / a.invariants[i], side, 1e-9) << name << " " << kInvariantNames[i];
      }
      EXPECT_NEAR(b.area / a.area, scale * scale, 1e-12 * scale * scale) << name;
      EXPECT_NEAR(b.gaussian, a.gaussian, 1e-10 * 4 * 3.15) << name;
    }
  }
}

TEST(SurfaceEnergy, is_invariant_under_rotation_and_translation) {
  expect_invariance(
      [](Cage cage) {
        cage.vertices = ((cage.vertices * some_rotation()).rowwise() + Eigen::RowVector3d(0.7, -0.4, 0.9)).eval();
        return cage;
      },
      1);
}

TEST(SurfaceEnergy, is_invariant_under_scaling_and_area_is_quadratic) {
  expect_invariance(
      [](Cage cage) {
        cage.vertices *= 37.5;
        return cage;
      },
      37.5);
}

TEST(SurfaceEnergy, is_invariant_under_reflection) {
  expect_invariance(
      [](Cage cage) {
        cage.vertices.col(0) *= -1;
        for (std::vector<int>& face : cage.faces) std::reverse(face.begin(), face.end());
        return cage;
      },
      1);
}

TEST(SurfaceEnergy, is_invariant_under_turning_the_surface_inside_out_but_for_what_is_odd) {
  expect_invariance(
      [](Cage cage) {
        for (std::vector<int>& face : cage.faces) std::reverse(face.begin(), face.end());
        return cage;
      },
      1, -1);
}

TEST(SurfaceEnergy, is_invariant_under_relabelling_vertices_faces_and_corners) {
  expect_invariance(
      [](const Cage& cage) {
        std::mt19937 engine(5);
        std::vector<int> number(cage.vertices.rows());
        std::iota(number.begin(), number.end(), 0);
        std::shuffle(number.begin(), number.end(), engine);
        Cage result = cage;
        for (std::size_t v = 0; v < number.size(); ++v)
          result.vertices.row(number[v]) = cage.vertices.row(static_cast<int>(v));
        for (std::vector<int>& face : result.faces) {
          for (int& v : face) v = number[v];
          std::rotate(face.begin(), face.begin() + engine() % face.size(), face.end());
        }
        std::shuffle(result.faces.begin(), result.faces.end(), engine);
        return result;
      },
      1);
}

TEST(SurfaceEnergy, is_the_weighted_sum_of_the_reported_functionals) {
  const Refined mesh = refined(reference_cage("g2"), 2);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, {4, 4, 2});
    const SurfaceIntegrals sums = surface_integrals(jets, mesh.control);
    for (const Weights& weights :
         {Weights{0.7, 0, 0, 0, 0, 0}, Weights{0.1, 0.2, 0, 0.4, 0, 0}, Weights{0, 0, 2, 3, 4, 5, 6, 0},
          Weights{0, 0, 0, 0, 0, 0, 0, 2}, Weights{1, 0, 0, 3, 0, 0, 1, 1e-2}}) {
      const EnergyValue value = SurfaceEnergy(jets, weights).evaluate(mesh.control, nullptr);
      double expected = 0;
      for (int f = 0; f < kFunctionalCount; ++f) expected += weights[f] * sums.functionals[f];
      EXPECT_NEAR(value.energy, expected, 1e-12 * expected);
      EXPECT_NEAR(value.area, sums.area, 1e-13 * sums.area);
      double with_powers = 0;
      for (int p = 0; p < kAreaPowerCount; ++p) with_powers += std::pow(value.area, p) * value.integrals[p];
      EXPECT_NEAR(value.energy, with_powers, 1e-14 * with_powers);
    }
  }
}

TEST(SurfaceEnergy, gradient_is_orthogonal_to_translations_rotations_and_scaling) {
  const Refined mesh = refined(reference_cage("g2"), 2);
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh.mesh, cap);
    const JetEvaluator jets(layout, {4, 4, 2});
    for (int f = 0; f < kFunctionalCount; ++f) {
      Weights weights{};
      weights[f] = 1;
      Points gradient;
      SurfaceEnergy(jets, weights).evaluate(mesh.control, &gradient);
      std::vector<Points> motions(7, Points::Zero(mesh.control.rows(), 3));
      for (int axis = 0; axis < 3; ++axis) {
        motions[axis].col(axis).setOnes();
        for (int v = 0; v < mesh.control.rows(); ++v) {
          motions[3 + axis].row(v) = Vector3::Unit(axis).cross(Vector3(mesh.control.row(v))).transpose();
        }
      }
      motions[6] = mesh.control;
      for (const Points& motion : motions) {
        EXPECT_LT(std::abs(gradient.cwiseProduct(motion).sum()), 1e-10 * gradient.norm() * motion.norm())
            << kFunctionalNames[f] << " cap " << static_cast<int>(cap);
      }
    }
  }
}

TEST(SurfaceEnergy, regularity_is_small_for_a_patch_that_collapses) {
  Refined mesh = refined(reference_cage("torus"), 0);
  const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
  const JetEvaluator jets(layout, {4, 4, 2});
  const SurfaceEnergy energy(jets, {1, 0, 0, 0, 0, 0});
  EXPECT_GT(energy.evaluate(mesh.control, nullptr).regularity, 0.1);
  mesh.control.col(2).setZero();
  mesh.control.col(1).setZero();
  const EnergyValue flat = energy.evaluate(mesh.control, nullptr);
  EXPECT_FALSE(flat.energy < 1e6) << "a segment has no finite energy";
}

}  // namespace
}  // namespace umbilic::test
