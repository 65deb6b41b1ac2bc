// SPDX-License-Identifier: MIT
/// \file
/// Open cages from the cage to reports and drawings, nothing optimized.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "driver/run.h"
#include "driver/surface.h"
#include "driver/tessellate.h"
#include "mesh/open_cages.h"

namespace umbilic::test {
namespace {

TEST(OpenEvaluation, sees_all_curvature_of_every_open_cage) {
  for (auto cages : {tame_open_cages(), wild_open_cages(), holed_cages()}) {
    for (const auto& [name, cage] : cages) {
      SCOPED_TRACE(name);
      const bool every_cap =
          name == "fan of 3" || name == "L" || name == "tube";  // tables of a valence take their time
      for (const CapKind cap : {CapKind::kSmooth, CapKind::kFlat, CapKind::kNone}) {
        if (cap != CapKind::kSmooth && !every_cap) continue;
        const Result<EvaluationReport> report = evaluate(cage, cap, 1);
        ASSERT_TRUE(report.ok()) << report.error().message;
        EXPECT_TRUE(report->energies.resolved);
        EXPECT_TRUE(report->energies.boundary_turning.has_value());
        EXPECT_FALSE(report->energies.below_bound);
        EXPECT_FALSE(report->energies.embedded) << "that is proved of closed surfaces only";
        EXPECT_GT(report->energies.area, 0);
      }
    }
  }
}

TEST(OpenEvaluation, of_a_closed_cage_has_no_boundary) {
  EXPECT_FALSE(evaluate(cube(), CapKind::kSmooth, 1)->energies.boundary_turning.has_value());
}

/// The limit mesh has the surface's characteristic, and edges with one quad on the boundary only.
TEST(OpenTessellation, joins_the_surface_s_grids_and_leaves_its_boundary_open) {
  for (const auto& [cage, loops, characteristic] :
       {std::tuple{tube(6, 2), 2, 0}, {half_disc(4), 1, 1}, {with_holes(cube(), {0}), 1, 1}, {disc(5), 1, 1}}) {
    for (const bool symmetric : {false, true}) {
      const RefinedCage refined = refine_to_evaluable(cage, 1, symmetric).value();
      const PatchLayout layout(refined.mesh, CapKind::kSmooth, face_orbits(refined.mesh, refined.symmetry));
      const int density = 3;
      const LimitMesh mesh = tessellate(refined.mesh, refined.symmetry, layout, refined.control, density);
      EXPECT_TRUE(mesh.positions.allFinite());
      EXPECT_TRUE(mesh.normals.allFinite());
      std::map<std::pair<int, int>, int> uses;
      for (const auto& quad : mesh.quads) {
        for (int i = 0; i < 4; ++i) ++uses[std::minmax(quad[i], quad[(i + 1) % 4])];
      }
      int open = 0;
      for (const auto& [edge, count] : uses) {
        EXPECT_LE(count, 2);
        open += count == 1;
      }
      EXPECT_GT(open, 3 * loops);
      EXPECT_EQ(mesh.positions.rows() - static_cast<int>(uses.size()) + static_cast<int>(mesh.quads.size()),
                characteristic);
    }
  }
}

TEST(OpenTessellation, keeps_one_side_where_a_symmetry_exchanges_both) {
  // Half a turn about the diagonal maps z = x y (1 + ...) of a saddle to itself, and its sides to one another.
  Cage cage = sheet(2, 2);
  for (int v = 0; v < 9; ++v) {
    const double x = v % 3 - 1, y = v / 3 - 1;
    cage.vertices.row(v) << x, y, 0.3 * (x * x - y * y) + 0.01 * (x * x * x - y * y * y);
  }
  const RefinedCage part = refine_to_evaluable(cage, 1, true).value(),
                    all = refine_to_evaluable(cage, 1, false).value();
  EXPECT_GT(part.symmetry.order, 1);
  const PatchLayout some(part.mesh, CapKind::kSmooth, face_orbits(part.mesh, part.symmetry));
  const PatchLayout each(all.mesh, CapKind::kSmooth);
  const LimitMesh a = tessellate(part.mesh, part.symmetry, some, part.control, 4);
  const LimitMesh b = tessellate(all.mesh, all.symmetry, each, all.control, 4);
  EXPECT_LT((a.positions - b.positions).norm(), 1e-10);
  EXPECT_LT((a.normals - b.normals).norm(), 1e-10);
  EXPECT_LT((a.curvatures - b.curvatures).norm(), 1e-9);
}

TEST(OpenCageOf, a_refined_surface_has_its_faces_only_and_evaluates_as_it_did_with_the_standard_ghosts) {
  for (const Cage& cage : {tube(5, 2), disc(5)}) {
    const RefinedCage refined = refine_to_evaluable(cage, 1, false).value();
    const Cage written = to_cage(refined.mesh, refined.placement.back(refined.control));
    EXPECT_EQ(static_cast<int>(written.faces.size()), refined.mesh.surface_face_count());
    const double expected = evaluate(cage, CapKind::kNone, 2)->energies.functionals[kBending];
    EXPECT_NEAR(evaluate(written, CapKind::kNone, 1)->energies.functionals[kBending] / expected, 1, 1e-10);
  }
}

}  // namespace
}  // namespace umbilic::test
