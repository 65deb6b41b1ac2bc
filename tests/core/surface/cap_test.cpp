// SPDX-License-Identifier: MIT
/// \file
/// Caps are partitions of unity, leave the limit surface alone at their rim, and are smooth polynomials at their
/// centre.
#include "surface/cap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/rough_cages.h"
#include "surface/whole_basis.h"

namespace umbilic::test {
namespace {

TEST(CapSlow, basis_sums_to_one_and_its_derivatives_to_zero) {
  for (const CapShape shape : kAllShapes) {
    for (int valence = 3; valence <= 24; ++valence) {
      const CapSector& cap = cap_sector(valence, shape);
      for (const auto& [u, v] : {std::pair{0.03, 0.9}, {0.4, 0.3}, {0.7, 0.02}, {0.99, 0.97}}) {
        const DerivativeRows basis = whole_basis(cap, 0, u * rim(shape), v * rim(shape));
        const Eigen::VectorXd sums = basis.rowwise().sum();
        // Round-off of the sum, relative to the terms; the fit solves a system with condition about 100.
        EXPECT_NEAR(sums[0], 1, 1e-13) << "valence " << valence;
        for (int order = 1; order < 4; ++order) {
          EXPECT_LT(sums.segment(derivative_index(order, 0), order + 1).cwiseAbs().maxCoeff(),
                    1e-12 * std::max(1.0, largest(basis, order)))
              << "valence " << valence << " order " << order;
        }
      }
    }
  }
}

TEST(Cap, flattening_of_a_point_is_nothing) {
  for (int valence = 3; valence <= 24; ++valence) {
    const CapSector& cap = cap_sector(valence, CapShape::kFlat);
    for (const auto& [u, v] : {std::pair{0.1, 0.9}, {0.4, 0.3}, {0.7, 0.2}}) {
      const DerivativeRows flattening = sector_flattening(cap, u, v);
      EXPECT_LT(flattening.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12) << "valence " << valence;  // eq. 8 is steep
    }
  }
}

TEST(Cap, equals_the_limit_surface_through_order_3_on_its_rim) {
  for (const CapShape shape : kPolynomialShapes) {
    for (const int valence : {3, 5, 6, 12, 24}) {
      const CapSector& cap = cap_sector(valence, shape);
      const double r = rim(shape);
      for (const auto& [u, v] : {std::pair{r, 0.3 * r}, {r, 0.8 * r}, {0.4 * r, r}, {r, r}}) {
        const DerivativeRows difference = whole_basis(cap, 0, u, v) - sector_limit(cap, u, v);
        EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-14);  // b and three derivatives are exactly 0
      }
    }
  }
}

TEST(Cap, tends_to_the_limit_surface_through_order_3_at_its_rim) {
  // b = O(e^4) at the distance e, so that its derivative of order k is O(e^(4 - k)).
  for (const CapShape shape : kPolynomialShapes) {
    for (const int valence : {3, 5, 9}) {
      const CapSector& cap = cap_sector(valence, shape);
      const double r = rim(shape);
      double last[4] = {};
      for (const double e : {1e-2, 1e-3}) {
        const DerivativeRows difference = whole_basis(cap, 0, r - e, 0.4 * r) - cap.net().basis(r - e, 0.4 * r);
        for (int order = 0; order < 4; ++order) {
          const double now = largest(difference, order);
          if (last[order] > 0) {
            EXPECT_LT(now / last[order], 1.3 * std::pow(0.1, 4 - order)) << "order " << order;
          }
          last[order] = now;
        }
        EXPECT_GT(last[3], 0);
      }
    }
  }
}

TEST(Cap, flat_cap_equals_the_limit_surface_on_its_rim) {
  // Eq. 8 is exp(-2 exp(-1/(1-t)) / t ...) small: below round-off already at 0.99.
  for (const int valence : {3, 5, 9}) {
    const CapSector& cap = cap_sector(valence, CapShape::kFlat);
    for (const auto& [u, v] : {std::pair{1.0, 0.3}, {0.6, 1.0}, {0.995, 0.5}}) {
      EXPECT_LT(sector_flattening(cap, u, v).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(Cap, flat_cap_is_the_tangent_plane_at_its_centre) {
  // Where b = 1 to round-off, flattening = basis - limit position, so that X = S - ((S - S0) . n) n.
  for (const int valence : {3, 5, 9}) {
    const CapSector& cap = cap_sector(valence, CapShape::kFlat);
    DerivativeRows offset = cap.net().basis(0.01, 0.004);
    offset.row(0) -= cap.net().limit_position();
    for (int order = 0; order < 4; ++order) {
      EXPECT_LT(largest(sector_flattening(cap, 0.01, 0.004) - offset, order), 1e-12 * largest(offset, order));
    }
  }
}

/// Derivatives of the monomial x^i y^j of the characteristic map, by the product rule.
Derivatives monomial(const CapSector& cap, int i, int j, double u, double v) {
  const Eigen::Matrix<double, kDerivativeCount, 2> xy = cap.net().basis(u, v) * cap.net().characteristic_net();
  Derivatives result = Derivatives::Unit(0);
  for (; i > 0; --i) result = product(xy.col(0), result);
  for (; j > 0; --j) result = product(xy.col(1), result);
  return result;
}

TEST(Cap, tends_to_the_polynomial_through_order_3_at_its_centre) {
  for (const CapShape shape : kPolynomialShapes) {
    for (const int valence : {3, 5, 8, 16}) {
      const CapSector& cap = cap_sector(valence, shape);
      const int size = cap.net().size();
      double last[4] = {};
      for (const double e : {1e-2, 1e-3}) {
        const double u = e, v = 0.7 * e;
        const DerivativeRows basis = sector_basis(cap, u, v);
        DerivativeRows difference = basis;  // X - Q, as a function of control points and coefficients
        int column = size;
        for (int k = 0; k <= degree(shape); ++k) {
          for (int l = 0; l <= k; ++l) difference.col(column++) -= monomial(cap, k - l, l, u, v);
        }
        ASSERT_EQ(column, basis.cols());
        for (int order = 0; order < 4; ++order) {
          // (1 - b)(S - Q) = O(e^4) has derivatives O(e^(4 - k)).
          const double now = largest(difference, order);
          if (last[order] > 0) {
            EXPECT_LT(now / last[order], 1.3 * std::pow(0.1, 4 - order)) << valence << " order " << order;
          }
          last[order] = now;
        }
      }
    }
  }
}

TEST(Cap, is_the_polynomial_of_its_coefficients_in_every_column) {
  // b Q with the blend divided out: at (u, v) the column of a monomial is b times the monomial.
  for (const CapShape shape : kPolynomialShapes) {
    const CapSector& cap = cap_sector(7, shape);
    const double u = 0.45 * rim(shape), v = 0.2 * rim(shape);
    const DerivativeRows basis = sector_basis(cap, u, v);
    const Derivatives b = basis.col(cap.net().size());  // times the monomial 1
    const Derivatives x2y = product(b, monomial(cap, 2, 1, u, v));
    EXPECT_LT((basis.col(cap.net().size() + 6 + 1) - x2y).norm(), 1e-12 * x2y.norm());
    // And the rest of the basis is (1 - b) S.
    const DerivativeRows rest = product(Derivatives(Derivatives::Unit(0) - b), cap.net().basis(u, v));
    EXPECT_LT((basis.leftCols(cap.net().size()) - rest).norm(), 1e-12 * rest.norm());
  }
}

}  // namespace
}  // namespace umbilic::test
