// SPDX-License-Identifier: MIT
/// \file
/// Caps are C^2 across spokes and between the faces of a sector, and C^3 but for the third derivative across the edge:
/// just as smooth as the spline.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "surface/whole_basis.h"

namespace umbilic::test {
namespace {

/// The basis of the sector after `sector` at (v, -u) as a function of (u, v): d/du = -d/dv', d/dv = d/du'.
DerivativeRows as_seen_from_the_sector_before(const DerivativeRows& rows) {
  DerivativeRows result(rows.rows(), rows.cols());
  for (int d = 0; d < kDerivativeCount; ++d) {
    result.row(d) = (kOrderU[d] % 2 == 0 ? 1 : -1) * rows.row(derivative_index(kOrderV[d], kOrderU[d]));
  }
  return result;
}

/// Expects equal derivatives, but for the third across an edge along v when `but` is kOrderU's 3.
void expect_equal(const DerivativeRows& a, const DerivativeRows& b, int skipped) {
  for (int d = 0; d < kDerivativeCount; ++d) {
    if (d == skipped) continue;
    const double scale = std::max(1.0, largest(a, kOrderU[d] + kOrderV[d]));
    // Round-off of refinement and of the fit, whose coefficients are found sector by sector.
    EXPECT_LT((a.row(d) - b.row(d)).cwiseAbs().maxCoeff(), 1e-11 * scale) << "derivative " << d;
  }
}

constexpr int kUuu = derivative_index(3, 0), kVvv = derivative_index(0, 3);

TEST(Cap, is_c2_across_spokes) {
  for (const CapShape shape : kAllShapes) {
    for (const int valence : {3, 5, 6, 9, 16, 24}) {
      const CapSector& cap = cap_sector(valence, shape);
      for (const double t : {0.04, 0.3, 0.7, 0.98}) {
        const double along = t * rim(shape);
        for (const int sector : {0, valence - 1}) {
          SCOPED_TRACE(testing::Message() << "valence " << valence << " at " << along);
          expect_equal(whole_basis(cap, sector, 0, along),
                       as_seen_from_the_sector_before(whole_basis(cap, sector + 1, along, 0)), kUuu);
        }
      }
    }
  }
}

TEST(Cap, flattening_is_c2_across_spokes) {
  for (const int valence : {3, 5, 9}) {
    const CapSector& cap = cap_sector(valence, CapShape::kFlat);
    for (const double along : {0.1, 0.4, 0.8}) {
      expect_equal(sector_flattening(cap, 0, along),
                   as_seen_from_the_sector_before(turned(cap.net(), sector_flattening(cap, along, 0), 1)), kUuu);
    }
  }
}

TEST(Cap, is_c2_between_the_faces_of_a_sector) {
  for (const CapShape shape : {CapShape::kBare, CapShape::kTwoRing, CapShape::kFourRing, CapShape::kSixteenRing}) {
    for (const int valence : {3, 5, 12}) {
      const CapSector& cap = cap_sector(valence, shape);
      for (const double edge : {1.0, 2.0, 3.0}) {
        if (edge >= (shape == CapShape::kBare ? 2 : rim(shape))) break;
        const double before = std::nextafter(edge, 0.0);
        for (const double t : {0.2, 0.9, 1.3}) {
          expect_equal(whole_basis(cap, 0, before, t), whole_basis(cap, 0, edge, t), kUuu);
          expect_equal(whole_basis(cap, 0, t, before), whole_basis(cap, 0, t, edge), kVvv);
        }
      }
    }
  }
}

TEST(Cap, is_c2_between_the_rings_of_refinement) {
  // Inside the first face the spline pieces meet at max(u, v) = 1/2, 1/4, ...
  for (const CapShape shape : kAllShapes) {
    const CapSector& cap = cap_sector(7, shape);
    for (const double edge : {0.5, 0.25}) {
      const double before = edge * std::nextafter(1.0, 0.0);
      expect_equal(whole_basis(cap, 0, before, 0.6 * edge), whole_basis(cap, 0, edge, 0.6 * edge), kUuu);
      expect_equal(whole_basis(cap, 0, 0.6 * edge, before), whole_basis(cap, 0, 0.6 * edge, edge), kVvv);
    }
  }
}

}  // namespace
}  // namespace umbilic::test
