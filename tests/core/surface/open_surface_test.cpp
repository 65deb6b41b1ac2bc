// SPDX-License-Identifier: MIT
/// \file
/// Limit surfaces with boundary: against deep subdivision, from level to level, and their caps.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mesh/boundary.h"
#include "mesh/hierarchy.h"
#include "mesh/open_cages.h"
#include "surface/all_caps.h"
#include "surface/deep_subdivision.h"
#include "surface/layout.h"

namespace umbilic::test {
namespace {

Refined evaluable(const Cage& cage, int extra = 0) {
  const PolygonMesh mesh(cage);
  return refined(mesh, cage.vertices, required_level(mesh).value() + extra);
}

SurfaceJet jet_of(const PatchSet& set, int patch, const Points& points, double u, double v) {
  const DerivativeRows basis = patch_basis(set.kind, u, v);
  SurfaceJet jet = SurfaceJet::Zero();
  for (int i = 0; i < set.columns; ++i) jet += basis.col(i) * points.row(set.points_of(patch)[i]);
  return jet;
}

std::map<std::string, Cage> all_open_cages() {
  std::map<std::string, Cage> cages = tame_open_cages();
  cages.merge(wild_open_cages());
  cages.merge(holed_cages());
  return cages;
}

TEST(OpenLayout, covers_every_face_of_the_surface_once_and_no_other) {
  for (const auto& [name, cage] : all_open_cages()) {
    for (const CapKind cap : kAllCaps) {
      for (const int extra : {0, 1, 2}) {
        SCOPED_TRACE(name);
        const PolygonMesh mesh = evaluable(cage, extra).mesh;
        const PatchLayout layout(mesh, cap);
        std::multiset<int> faces;
        for (const PatchSet& set : layout.sets()) {
          for (const int point : set.points) EXPECT_TRUE(point >= 0 && point < layout.point_count());
          for (const int h : set.halfedges) faces.insert(mesh.face(h));
        }
        EXPECT_EQ(static_cast<int>(faces.size()), mesh.surface_face_count());
        for (int f = 0; f < mesh.surface_face_count(); ++f) EXPECT_EQ(faces.count(f), 1u) << "face " << f;
      }
    }
  }
}

TEST(OpenLayout, uses_every_control_point_from_level_1_on) {
  for (const auto& [name, cage] : all_open_cages()) {
    SCOPED_TRACE(name);
    const PolygonMesh mesh = evaluable(cage, 1).mesh;
    const PatchLayout layout(mesh, CapKind::kNone);
    std::set<int> used;
    for (const PatchSet& set : layout.sets()) used.insert(set.points.begin(), set.points.end());
    EXPECT_EQ(static_cast<int>(used.size()), mesh.vertex_count());
  }
}

TEST(OpenLayout, has_wide_caps_where_the_boundary_leaves_room) {
  const auto shapes = [](int extra) {
    const PatchLayout layout(evaluable(disc(5), extra).mesh, CapKind::kSmooth);
    EXPECT_EQ(layout.caps().size(), 1u);
    return layout.caps()[0].shape;
  };
  EXPECT_EQ(shapes(0), CapShape::kTwoRing);  // two edges from the boundary after one step
  EXPECT_EQ(shapes(1), CapShape::kFourRing);
}

TEST(OpenLayout, fits_the_caps_at_the_boundary_to_the_sectors_that_carry_surface) {
  for (int k = 3; k <= 8; ++k) {
    const Refined mesh = evaluable(half_disc(k));
    const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
    ASSERT_EQ(layout.caps().size(), 1u);
    const Cap& cap = layout.caps()[0];
    EXPECT_EQ(cap.valence, 2 * k);
    EXPECT_EQ(cap.sectors, k);
    EXPECT_EQ(cap.shape, CapShape::kOneRing);
  }
}

/// Every jet at the samples against the second implementation, which closes the window around a face by a polygon.
void expect_deep_subdivision(const Refined& mesh, double tolerance) {
  const PatchLayout layout(mesh.mesh, CapKind::kNone);
  const DeepSubdivision deep(mesh.mesh, mesh.control);
  for (const PatchSet& set : layout.sets()) {
    for (int p = 0; p < set.count(); ++p) {
      if (!is_regular_face(mesh.mesh, mesh.mesh.face(set.halfedges[p]))) continue;
      const SurfaceJet jet = jet_of(set, p, mesh.control, 0.3, 0.6);
      const SurfaceJet expected = deep.jet(set.halfedges[p], 0.3, 0.6);
      for (int order = 0; order < 4; ++order) EXPECT_LT(relative_difference(jet, expected, order), tolerance);
    }
  }
}

TEST(OpenLimit, equals_deep_subdivision_on_regular_faces_at_the_boundary) {
  for (const auto& [name, cage] : tame_open_cages()) {
    if (name == "one open") continue;
    SCOPED_TRACE(name);
    Refined mesh{PolygonMesh(cage), cage.vertices};
    mesh = refined(mesh.mesh, mesh.control, required_level(mesh.mesh).value());
    mesh.control += 0.02 * Random(8).points(mesh.control.rows());
    expect_deep_subdivision(mesh, 1e-12);
  }
}

/// The surface at a level as a function of the face's quarter: at (u, v) of the patch of half-edge h.
TEST(OpenLimit, is_the_same_at_every_level_with_ghosts_moved_at_random) {
  for (const auto& [name, cage] : all_open_cages()) {
    SCOPED_TRACE(name);
    Refined coarse = evaluable(cage);
    coarse.control += 0.05 * Random(5).points(coarse.control.rows());
    const Refined fine = refined(coarse.mesh, coarse.control, 1);
    const PatchLayout a(coarse.mesh, CapKind::kNone), b(fine.mesh, CapKind::kNone);
    // The quad of half-edge h in the fine mesh is face h and its first half-edge runs along h.
    std::vector<std::pair<int, int>> place(fine.mesh.surface_face_count());
    for (std::size_t s = 0; s < b.sets().size(); ++s) {
      for (int p = 0; p < b.sets()[s].count(); ++p) {
        place[fine.mesh.face(b.sets()[s].halfedges[p])] = {static_cast<int>(s), p};
      }
    }
    double worst = 0;
    for (const PatchSet& set : a.sets()) {
      for (int p = 0; p < set.count(); ++p) {
        const int h = set.halfedges[p];
        const auto& [s, q] = place[h];
        // The patch of the quarter may start at another of its corners.
        const int along = b.sets()[s].halfedges[q];
        int turns = 0;
        for (int g = along; g != 4 * h; g = fine.mesh.next(g)) ++turns;
        double u = 0.3, v = 0.8;
        const SurfaceJet here = jet_of(set, p, coarse.control, u / 2, v / 2);
        for (int t = 0; t < turns; ++t) {
          const double old = u;
          u = 1 - v;
          v = old;
        }
        const SurfaceJet there = jet_of(b.sets()[s], q, fine.control, u, v);
        worst = std::max(worst, (here.row(0) - there.row(0)).norm());
      }
    }
    EXPECT_LT(worst, 1e-14);
  }
}

TEST(OpenCap, keeps_what_it_is_fitted_to_where_the_surface_is_flat) {
  // Q is exact for linear functions of the characteristic map, so that a flat fan stays flat, and a fan in a plane
  // whose net is the characteristic one is the plane itself.
  for (int k = 3; k <= 8; ++k) {
    const CapSector& sector = cap_sector(2 * k, CapShape::kOneRing, k);
    Eigen::Matrix<double, Eigen::Dynamic, 2> net = sector.net().characteristic_net();
    const Eigen::MatrixXd coefficients = sector.fit() * net;
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(coefficients.rows(), 2);
    expected(1, 0) = expected(2, 1) = 1;
    EXPECT_LT((coefficients - expected).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(OpenCap, is_invariant_under_the_mirror_of_its_sectors) {
  for (int k = 3; k <= 8; ++k) {
    const CapSector& sector = cap_sector(2 * k, CapShape::kOneRing, k);
    const RingNet& net = sector.net();
    // The mirror takes sector j to k - 1 - j and (a, b) to (b, a). Q in the last sector's coordinates with x and y
    // exchanged along the mirror of that sector is Q of the mirrored net.
    Random random(7);
    Points points = random.points(net.size()), mirrored = points;
    for (int j = 0; j < 2 * k; ++j) {
      for (int a = 0; a <= 2; ++a) {
        for (int b = 0; b <= 2; ++b) mirrored.row(net.index(k - 1 - j, b, a)) = points.row(net.index(j, a, b));
      }
    }
    const Points q = sector.turn(k - 1) * (sector.fit() * points).eval(), r = sector.fit() * mirrored;
    // The mirror in the sector's middle line maps (x, y) to (c x + s y, s x - c y), with the angle of one sector.
    const double c = std::cos(std::numbers::pi / k), s = std::sin(std::numbers::pi / k);
    for (const auto& [x, y] : {std::pair{0.3, 0.1}, {0.5, 0.4}, {-0.2, 0.6}}) {
      const auto value = [&](const Points& p, double X, double Y) {
        return Vector3((p.row(0) + X * p.row(1) + Y * p.row(2) + X * X * p.row(3) + X * Y * p.row(4) +
                        Y * Y * p.row(5) + X * X * X * p.row(6) + X * X * Y * p.row(7) + X * Y * Y * p.row(8) +
                        Y * Y * Y * p.row(9))
                           .transpose());
      };
      EXPECT_LT((value(q, x, y) - value(r, c * x + s * y, s * x - c * y)).norm(), 1e-11);
    }
  }
}

}  // namespace
}  // namespace umbilic::test
