// SPDX-License-Identifier: MIT
/// \file
/// Limit meshes: closed like their surface, with normals and curvatures that fit it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "cage/generate.h"
#include "driver/run.h"
#include "driver/surface.h"
#include "driver/tessellate.h"

namespace umbilic {
namespace {

umbilic::Run started(const Cage& cage, CapKind cap, int level) {
  RunOptions options;
  options.weights = *weights_of("bending");
  options.cap = cap;
  options.first_level = options.last_level = level;
  return *umbilic::Run::create(cage, options);
}

Cage polygons(const LimitMesh& mesh) {
  Cage cage{mesh.positions, {}};
  for (const auto& quad : mesh.quads) cage.faces.emplace_back(quad.begin(), quad.end());
  return cage;
}

TEST(LimitMesh, is_a_closed_mesh_of_the_same_genus_with_density_squared_quads_per_patch) {
  for (const CapKind cap : {CapKind::kNone, CapKind::kFlat, CapKind::kSmooth}) {
    for (const int density : {1, 2, 5}) {
      const umbilic::Run run = started(*generate_cage("two-3"), cap, 1);
      const LimitMesh mesh = *run.limit_mesh(density);
      EXPECT_EQ(mesh.quads.size(), run.control_mesh().faces.size() * density * density);
      Cage cage = polygons(mesh);
      const std::size_t vertices = cage.vertices.rows();
      const Result<CageReport> report = validate(cage);
      ASSERT_TRUE(report.ok()) << report.error().message;
      EXPECT_EQ(report->genus, 2);
      EXPECT_EQ(cage.vertices.rows(), Eigen::Index(vertices));
      EXPECT_EQ(cage.faces, polygons(mesh).faces) << "quads are oriented outwards";
    }
  }
}

/// The quad's vertices from the least one on.
std::array<int, 4> from_least(std::array<int, 4> quad) {
  std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
  return quad;
}

TEST(LimitMesh, moved_by_the_symmetry_group_is_that_of_all_patches) {
  for (const char* name : {"two-3", "tetrahedron-frame", "torus"}) {
    for (const CapKind cap : {CapKind::kNone, CapKind::kFlat, CapKind::kSmooth}) {
      const RefinedCage cage = *refine_to_evaluable(*generate_cage(name), 1, true);
      ASSERT_GT(cage.symmetry.order, 4);
      const PatchLayout orbits(cage.mesh, cap, face_orbits(cage.mesh, cage.symmetry)), all(cage.mesh, cap);
      const EnergyDensity energy{*weights_of("bending"), 1};
      const LimitMesh moved = tessellate(cage.mesh, cage.symmetry, orbits, cage.control, 3, energy);
      const LimitMesh plain = tessellate(cage.mesh, {}, all, cage.control, 3, energy);
      const double extent = plain.positions.cwiseAbs().maxCoeff(), curvature = plain.curvatures.cwiseAbs().maxCoeff();
      EXPECT_LT((moved.positions - plain.positions).cwiseAbs().maxCoeff(), 1e-13 * extent) << name;
      // Near extraordinary vertices derivatives lose digits to refinement.
      EXPECT_LT((moved.normals - plain.normals).cwiseAbs().maxCoeff(), 1e-11) << name;
      EXPECT_LT((moved.curvatures - plain.curvatures).cwiseAbs().maxCoeff(), 1e-9 * curvature) << name;
      EXPECT_LT((moved.densities - plain.densities).cwiseAbs().maxCoeff(), 1e-9 * curvature * curvature) << name;
      std::set<std::array<int, 4>> quads, expected;
      for (const auto& quad : moved.quads) quads.insert(from_least(quad));
      for (const auto& quad : plain.quads) expected.insert(from_least(quad));
      EXPECT_EQ(quads, expected) << name;
      EXPECT_EQ(quads.size(), plain.quads.size());
    }
  }
}

/// Faces' normals differ from the vertices' by no more than the surface turns within a quad.
TEST(LimitMesh, has_unit_normals_that_agree_with_its_faces) {
  for (const CapKind cap : {CapKind::kFlat, CapKind::kSmooth}) {
    const LimitMesh mesh = *started(*generate_cage("two-3"), cap, 2).limit_mesh(6);
    for (const auto& quad : mesh.quads) {
      const Vector3 a = mesh.positions.row(quad[2]) - mesh.positions.row(quad[0]);
      const Vector3 b = mesh.positions.row(quad[3]) - mesh.positions.row(quad[1]);
      const Vector3 n = a.cross(b).normalized();
      for (const int v : quad) {
        EXPECT_NEAR(mesh.normals.row(v).norm(), 1, 1e-12);
        EXPECT_GT(mesh.normals.row(v).dot(n), 0.9);
      }
    }
  }
}

TEST(LimitMesh, of_a_minimized_cube_has_the_curvatures_of_a_sphere) {
  RunOptions options;
  options.weights = *weights_of("bending");
  options.last_level = 2;
  umbilic::Run run = *umbilic::Run::create(*generate_cage("cube"), options);
  while (!run.step(10)) {
  }
  const LimitMesh mesh = *run.limit_mesh(3);
  const double radius = std::sqrt(run.energies().area / (4 * 3.14159265358979323846));
  for (int v = 0; v < mesh.positions.rows(); ++v) {
    EXPECT_NEAR(mesh.curvatures(v, 0) * radius, 1, 0.15) << "vertex " << v;
    EXPECT_NEAR(mesh.curvatures(v, 1) * radius, 1, 0.15) << "vertex " << v;
    EXPECT_GE(mesh.curvatures(v, 0), mesh.curvatures(v, 1));
  }
}

/// Of the densities over the mesh's quads, as two triangles each, by the corners' mean.
double integral(const LimitMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c, d] : mesh.quads) {
    for (const auto& [second, third] : {std::pair{b, c}, std::pair{c, d}}) {
      const Vector3 one = mesh.positions.row(second) - mesh.positions.row(a);
      const Vector3 other = mesh.positions.row(third) - mesh.positions.row(a);
      sum += one.cross(other).norm() / 6 * (mesh.densities[a] + mesh.densities[second] + mesh.densities[third]);
    }
  }
  return sum;
}

/// All orders and powers of the area, alone and blended. A surface that is far from optimal tests more than a
/// minimizer.
TEST(LimitMesh, has_densities_whose_integral_tends_to_the_energy_as_the_square_of_the_spacing) {
  for (const char* terms : {"bending=1", "willmore=1", "mvs=1", "mvs_cross=1", "mehlum_tarrou=1",
                            "curvedness_variation=1", "bending=0.9,mvs_cross=0.1,curvedness_variation=0.01"}) {
    RunOptions options;
    options.weights = *parse_weights(terms);
    options.cap = CapKind::kSmooth;
    options.first_level = options.last_level = 1;
    const umbilic::Run run = *umbilic::Run::create(*generate_cage("two-3"), options);
    double energy = 0;
    for (int f = 0; f < kFunctionalCount; ++f) {
      if (options.weights[f] != 0) energy += options.weights[f] * run.energies().functionals[f];
    }
    const double coarse = std::abs(integral(*run.limit_mesh(12, options.weights)) - energy);
    const double fine = std::abs(integral(*run.limit_mesh(24, options.weights)) - energy);
    EXPECT_LT(coarse, 0.05 * energy) << terms;
    EXPECT_LT(fine, 0.35 * coarse) << terms << ": a quarter, but for higher powers of the spacing";
  }
}

/// Also far away and of another size: a density is in 1/length^2 of the cage's own units.
TEST(LimitMesh, of_a_nearly_round_sphere_has_the_bending_density_2_over_the_squared_radius) {
  Cage cage = *generate_cage("cube");
  cage.vertices = (40 * cage.vertices).rowwise() + Vector3(100, -200, 300).transpose().eval();
  RunOptions options;
  options.weights = *weights_of("bending");
  options.last_level = 2;
  umbilic::Run run = *umbilic::Run::create(cage, options);
  while (!run.step(10)) {
  }
  const double expected = 8 * 3.14159265358979323846 / run.energies().area;  // 2 / r^2
  const LimitMesh mesh = *run.limit_mesh(3, options.weights);
  for (int v = 0; v < mesh.densities.size(); ++v) {
    EXPECT_NEAR(mesh.densities[v], expected, 0.25 * expected) << "vertex " << v << ": curvatures are within 0.15";
    EXPECT_NEAR(mesh.densities[v], mesh.curvatures.row(v).squaredNorm(), 1e-6 * expected);
  }
}

TEST(LimitMesh, has_no_density_of_an_energy_that_is_infinite) {
  const umbilic::Run run = started(*generate_cage("two-3"), CapKind::kNone, 1);
  EXPECT_TRUE(run.limit_mesh(2, weights_of("bending").value()).ok());
  const Result<LimitMesh> infinite = run.limit_mesh(2, weights_of("mvs").value());
  ASSERT_FALSE(infinite.ok());
  EXPECT_NE(infinite.error().message.find("mvs"), std::string::npos) << infinite.error().message;
}

TEST(LimitMesh, has_no_densities_unless_they_are_asked_for) {
  EXPECT_EQ(started(*generate_cage("cube"), CapKind::kSmooth, 1).limit_mesh(2)->densities.size(), 0);
}

}  // namespace
}  // namespace umbilic
