// SPDX-License-Identifier: MIT
/// \file
/// Energies of symmetric surfaces by one patch for each orbit against those by all patches.
#include <gtest/gtest.h>

#include "cage/generate.h"
#include "energy/surface_energy.h"
#include "mesh/coordinates.h"
#include "mesh/hierarchy.h"
#include "mesh/rough_cages.h"
#include "surface/few_points.h"

namespace umbilic::test {
namespace {

/// Any rule that no symmetry of a face changes gives equal sums; cheap ones do as well as exact ones.

/// A surface with the symmetry of its cage and nothing else in common with it: its unknowns are moved at random.
struct Symmetric {
  PolygonMesh mesh;
  SymmetryGroup group;
  Coordinates coordinates;
  Points control;

  Symmetric(const Refined& refined, SymmetryGroup symmetry)
      : mesh(refined.mesh), group(std::move(symmetry)), coordinates(mesh, group) {
    const Eigen::VectorXd start = coordinates.unknowns(refined.control);
    control = coordinates.control(start + 0.01 * Random(3).matrix<Eigen::VectorXd>(start.size(), 1));
  }
};

std::vector<Symmetric> evaluable_levels(const Cage& cage, int last) {
  std::vector<Symmetric> result;
  Refined level{PolygonMesh(cage), cage.vertices};
  SymmetryGroup group = find_symmetry(level.mesh, level.control);
  for (int i = 1; i <= last; ++i) {
    group = umbilic::refined(group, level.mesh);
    level = refined(level.mesh, level.control, 1);
    if (is_evaluable(level.mesh)) result.emplace_back(level, group);
  }
  return result;
}

/// Equal energies of `count` functionals, from the first on.
void expect_equal(const Symmetric& surface, CapKind cap, int count) {
  const PatchLayout whole(surface.mesh, cap), part(surface.mesh, cap, face_orbits(surface.mesh, surface.group));
  const JetEvaluator all(whole, kFewPoints), one_of_each(part, kFewPoints);
  for (int functional = 0; functional < count; ++functional) {
    Weights weights{};
    weights[functional] = 1;
    Points gradient, part_of_gradient;
    const EnergyValue expected = SurfaceEnergy(all, weights).evaluate(surface.control, &gradient);
    const EnergyValue value = SurfaceEnergy(one_of_each, weights).evaluate(surface.control, &part_of_gradient);
    EXPECT_NEAR(value.energy / expected.energy, 1, 1e-11);
    EXPECT_NEAR(value.area / expected.area, 1, 1e-13);
    EXPECT_NEAR(value.gaussian, expected.gaussian, 1e-11 * 40);  // up to 40 = 4 pi (genus - 1) of a mean frame
    EXPECT_NEAR(value.regularity / expected.regularity, 1, 1e-9) << "the least is met in every orbit";
    const Eigen::VectorXd reduced = surface.coordinates.pull_back(gradient);
    EXPECT_LT((surface.coordinates.pull_back(part_of_gradient) - reduced).norm(), 1e-11 * reduced.norm());
  }
}

void expect_equal_with_every_functional_and_cap(const std::string& name, FrameFamily family) {
  for (const Symmetric& surface : evaluable_levels(*generate_cage(name, {.family = family}), 2)) {
    SCOPED_TRACE(name + (family == FrameFamily::kHub ? ", hub, " : ", flag, ") + surface.group.name);
    for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat}) expect_equal(surface, cap, kFunctionalCount);
    expect_equal(surface, CapKind::kNone, kBending + 1);
  }
}

TEST(OnePatchPerOrbit, gives_energies_and_reduced_gradients_of_all_patches_on_small_cages) {
  for (const char* name : {"cube", "torus", "two-3", "tetrahedron-frame"}) {
    expect_equal_with_every_functional_and_cap(name, FrameFamily::kFlag);
  }
}

TEST(OnePatchPerOrbitSlow, gives_energies_and_reduced_gradients_of_all_patches_on_every_cage_of_both_families) {
  for (const CageName& name : cage_names()) {
    if (name.open) continue;
    for (const FrameFamily family : {FrameFamily::kHub, FrameFamily::kFlag}) {
      expect_equal_with_every_functional_and_cap(name.name, family);
    }
  }
}

TEST(OnePatchPerOrbit, multiplicities_are_the_sizes_of_the_orbits_and_add_up_to_all_faces) {
  for (const Symmetric& surface : evaluable_levels(*generate_cage("cube-frame"), 2)) {
    const Orbits orbits = face_orbits(surface.mesh, surface.group);
    const PatchLayout layout(surface.mesh, CapKind::kSmooth, orbits);
    std::vector<int> met(orbits.sizes.size(), 0);
    double faces = 0;
    for (const PatchSet& set : layout.sets()) {
      for (int p = 0; p < set.count(); ++p) {
        const int orbit = orbits.of[surface.mesh.face(set.halfedges[p])];
        ++met[orbit];
        EXPECT_EQ(set.multiplicities[p], orbits.sizes[orbit]);
        faces += set.multiplicities[p];
      }
    }
    EXPECT_EQ(met, std::vector<int>(orbits.sizes.size(), 1));
    EXPECT_EQ(faces, surface.mesh.face_count());
    EXPECT_EQ(layout.face_count(), surface.mesh.face_count());
    EXPECT_EQ(surface.mesh.face_count(), 48 * static_cast<int>(orbits.sizes.size())) << "no symmetry keeps a face";
  }
}

TEST(OnePatchPerOrbit, without_symmetry_is_every_patch) {
  const Refined mesh = rough(cube(), 2, 0.1, 1);
  const PatchLayout whole(mesh.mesh, CapKind::kSmooth);
  const PatchLayout orbits(mesh.mesh, CapKind::kSmooth, face_orbits(mesh.mesh, SymmetryGroup{}));
  ASSERT_EQ(orbits.sets().size(), whole.sets().size());
  EXPECT_EQ(orbits.point_count(), whole.point_count());
  for (std::size_t s = 0; s < whole.sets().size(); ++s) {
    EXPECT_EQ(orbits.sets()[s].points, whole.sets()[s].points);
    EXPECT_EQ(orbits.sets()[s].multiplicities, std::vector<double>(whole.sets()[s].count(), 1.0));
  }
}

TEST(OnePatchPerOrbit, keeps_only_the_caps_that_its_patches_need) {
  for (const Symmetric& surface : evaluable_levels(*generate_cage("two-5"), 2)) {
    const Orbits orbits = face_orbits(surface.mesh, surface.group);
    for (const CapKind cap : {CapKind::kFlat, CapKind::kSmooth}) {
      const PatchLayout layout(surface.mesh, cap, orbits), whole(surface.mesh, cap);
      EXPECT_EQ(whole.caps().size(), 4u) << "outer and inner axis points of two junctions";
      EXPECT_EQ(layout.caps().size(), 2u) << "a mirror exchanges the junctions";
      EXPECT_EQ(2 * (layout.point_count() - layout.control_count()), whole.point_count() - whole.control_count());
    }
  }
}

}  // namespace
}  // namespace umbilic::test
