// SPDX-License-Identifier: MIT
/// \file
/// The layout covers every face once, gives caps the room there is, and its extension is linear with the right
/// transpose.
#include "surface/layout.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/rough_cages.h"
#include "surface/all_caps.h"

namespace umbilic::test {
namespace {

TEST(PatchLayout, covers_every_face_exactly_once) {
  for (const CapKind cap : kAllCaps) {
    for (const int steps : {1, 2, 3}) {
      for (const Cage& cage : {cube(), trapezohedron(5), trapezohedron(9)}) {
        const PolygonMesh mesh = refined(cage, steps).mesh;
        const PatchLayout layout(mesh, cap);
        std::multiset<int> faces;
        for (const PatchSet& set : layout.sets()) {
          EXPECT_EQ(set.points.size(), static_cast<std::size_t>(set.count() * set.columns));
          for (const int h : set.halfedges) faces.insert(mesh.face(h));
        }
        EXPECT_EQ(static_cast<int>(faces.size()), mesh.face_count());
        for (int f = 0; f < mesh.face_count(); ++f) EXPECT_EQ(faces.count(f), 1u) << "face " << f;
      }
    }
  }
}

TEST(PatchLayout, a_patch_at_a_cap_starts_at_the_extraordinary_vertex) {
  const PolygonMesh mesh = refined(trapezohedron(6), 2).mesh;
  for (const CapKind cap : kAllCaps) {
    const PatchLayout layout(mesh, cap);
    for (const PatchSet& set : layout.sets()) {
      for (int p = 0; p < set.count() && set.kind.at_extraordinary(); ++p) {
        EXPECT_EQ(mesh.origin(set.halfedges[p]), layout.caps()[set.caps[p]].vertex);
        EXPECT_EQ(mesh.valence(mesh.origin(set.halfedges[p])), set.kind.valence);
      }
    }
  }
}

/// The shapes of the caps of a valence.
std::set<CapShape> shapes_of(const PatchLayout& layout, int valence) {
  std::set<CapShape> shapes;
  for (const Cap& cap : layout.caps()) {
    if (cap.valence == valence) shapes.insert(cap.shape);
  }
  return shapes;
}

TEST(PatchLayout, smooth_caps_take_as_many_rings_as_do_not_overlap) {
  for (const auto& [steps, shape] : {std::pair{1, CapShape::kOneRing},
                                     {2, CapShape::kTwoRing},
                                     {3, CapShape::kFourRing},
                                     {4, CapShape::kEightRing},
                                     {5, CapShape::kSixteenRing},
                                     {6, CapShape::kSixteenRing}}) {
    const PatchLayout layout(refined(cube(), steps).mesh, {CapKind::kSmooth, kMostCapRings});
    EXPECT_EQ(shapes_of(layout, 3), std::set{shape}) << "level " << steps;
  }
}

TEST(PatchLayout, wide_caps_of_higher_valence_take_half_of_their_room) {
  for (const auto& [steps, shape] : {std::pair{2, CapShape::kTwoRing},
                                     {3, CapShape::kFourRing},
                                     {4, CapShape::kFourRing},
                                     {5, CapShape::kEightRing}}) {
    const PatchLayout layout(refined(trapezohedron(7), steps).mesh, {CapKind::kSmooth, kMostCapRings});
    EXPECT_EQ(shapes_of(layout, 7), std::set{shape}) << "level " << steps;
  }
}

TEST(PatchLayout, smooth_caps_take_no_more_rings_than_they_may) {
  const PolygonMesh mesh = refined(cube(), 4).mesh;
  EXPECT_EQ(shapes_of(PatchLayout(mesh, CapKind::kSmooth), 3), std::set{CapShape::kFourRing});
  for (const auto& [most, shape] : {std::pair{1, CapShape::kOneRing},
                                    {2, CapShape::kTwoRing},
                                    {4, CapShape::kFourRing},
                                    {8, CapShape::kEightRing}}) {
    EXPECT_EQ(shapes_of(PatchLayout(mesh, {CapKind::kSmooth, most}), 3), std::set{shape});
  }
}

TEST(PatchLayout, flat_and_bare_caps_have_no_coefficients) {
  const PolygonMesh mesh = refined(cube(), 2).mesh;
  for (const CapKind cap : {CapKind::kNone, CapKind::kFlat}) {
    EXPECT_EQ(PatchLayout(mesh, cap).point_count(), mesh.vertex_count());
  }
  EXPECT_EQ(PatchLayout(mesh, CapKind::kSmooth).point_count(),
            mesh.vertex_count() + 8 * 3 * coefficient_count(CapShape::kTwoRing));
}

/// Expects the points of a layout to be the fits of what each sector sees.
void expect_fits(const PatchLayout& layout, const Points& control) {
  const Points points = layout.extend(control);
  EXPECT_EQ(points.topRows(layout.control_count()), control);
  for (const Cap& cap : layout.caps()) {
    const CapSector& sector = cap_sector(cap.valence, cap.shape);
    for (int j = 0; j < cap.valence; ++j) {
      Points net(sector.net().size(), 3);
      net.row(0) = control.row(cap.net[0]);
      for (int a = 1; a <= sector.net().control_rings(); ++a) {
        for (int b = 0; b <= sector.net().control_rings(); ++b) {
          for (int k = 0; k < cap.valence; ++k) {  // sector k as seen from sector j
            net.row(sector.net().index(k, a, b)) = control.row(cap.net[sector.net().index(j + k, a, b)]);
          }
        }
      }
      const Points expected = sector.fit() * net;
      const auto count = expected.rows();
      const Points found = points.middleRows(cap.first_coefficient + count * j, count);
      EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm());
    }
  }
}

TEST(PatchLayout, extends_control_points_by_the_fit_of_each_sector) {
  for (const int steps : {2, 3, 4}) {
    const Refined mesh = rough(trapezohedron(5), steps, 0.1, 2);
    expect_fits(PatchLayout(mesh.mesh, CapKind::kSmooth), mesh.control);
  }
}

TEST(PatchLayout, pull_back_is_the_transpose_of_extend) {
  for (const int steps : {1, 2, 3}) {
    const Refined mesh = rough(trapezohedron(5), steps, 0.1, 2);
    const PatchLayout layout(mesh.mesh, CapKind::kSmooth);
    Random random(11);
    const Points x = random.points(layout.control_count()), w = random.points(layout.point_count());
    Points pulled = w;
    layout.pull_back(pulled);
    const double forward = layout.extend(x).cwiseProduct(w).sum();
    const double backward = x.cwiseProduct(pulled.topRows(layout.control_count())).sum();
    EXPECT_NEAR(forward, backward, 1e-11 * std::abs(forward));  // sums of thousands of terms
    EXPECT_LT((layout.extension() * x - layout.extend(x)).norm(), 1e-12 * layout.extend(x).norm());
  }
}

}  // namespace
}  // namespace umbilic::test
