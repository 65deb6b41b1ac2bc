// SPDX-License-Identifier: MIT
/// \file
/// The polynomial of a smooth cap: what it reproduces, its symmetry, and that it is the least-squares fit.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/rough_cages.h"
#include "surface/blend.h"
#include "surface/quadrature.h"
#include "surface/whole_basis.h"

namespace umbilic::test {
namespace {

/// The first `count` monomials at (x, y), in the order of the fit.
Eigen::VectorXd monomials(Eigen::Index count, double x, double y) {
  Eigen::VectorXd values(count);
  int column = 0;
  for (int k = 0; column < count; ++k) {
    for (int l = 0; l <= k; ++l) values[column++] = std::pow(x, k - l) * std::pow(y, l);
  }
  return values;
}

/// Value at (x, y) of the polynomial with coefficients in the order of the fit.
double polynomial(const Eigen::VectorXd& coefficients, double x, double y) {
  return coefficients.dot(monomials(coefficients.size(), x, y));
}

TEST(FitSlow, reproduces_constants_and_the_characteristic_map) {
  for (const CapShape shape : kPolynomialShapes) {
    for (int valence = 3; valence <= 24; ++valence) {
      const CapSector& cap = cap_sector(valence, shape);
      const Eigen::MatrixXd xy = cap.fit() * cap.net().characteristic_net();
      const int count = coefficient_count(shape);
      EXPECT_LT((xy.col(0) - Eigen::VectorXd::Unit(count, 1)).norm(), 1e-11) << "x, valence " << valence;
      EXPECT_LT((xy.col(1) - Eigen::VectorXd::Unit(count, 2)).norm(), 1e-11) << "y, valence " << valence;
      EXPECT_LT((cap.fit().rowwise().sum() - Eigen::VectorXd::Unit(count, 0)).norm(), 1e-11) << "1, " << valence;
    }
  }
}

TEST(Fit, leaves_the_characteristic_map_as_it_is) {
  for (const CapShape shape : kPolynomialShapes) {
    for (const int valence : {3, 5, 11, 24}) {
      const CapSector& cap = cap_sector(valence, shape);
      const Eigen::Matrix<double, Eigen::Dynamic, 2> net = cap.net().characteristic_net();
      const double u = 0.4 * rim(shape), v = 0.55 * rim(shape);
      EXPECT_LT((whole_basis(cap, 1, u, v) * net - turned(cap.net(), cap.net().basis(u, v), 1) * net).norm(), 1e-10);
    }
  }
}

TEST(Fit, turns_with_the_sectors) {
  for (const CapShape shape : kPolynomialShapes) {
    for (const int valence : {3, 5, 8, 13, 24}) {
      const CapSector& cap = cap_sector(valence, shape);
      const Eigen::VectorXd net = Random(4).matrix<Eigen::VectorXd>(cap.net().size(), 1);
      const double angle = 2 * std::numbers::pi / valence, c = std::cos(angle), s = std::sin(angle);
      const Eigen::VectorXd here = cap.fit() * net, next = turned(cap.net(), cap.fit(), 1) * net;
      for (const auto& [x, y] : {std::pair{0.3, 0.1}, {-0.4, 0.8}, {0.9, -0.3}}) {
        EXPECT_NEAR(polynomial(next, x, y), polynomial(here, c * x - s * y, s * x + c * y), 1e-12);
      }
    }
  }
}

TEST(Fit, of_a_turned_net_is_the_turned_fit) {
  for (const CapShape shape : kPolynomialShapes) {
    for (const int valence : {3, 5, 8, 13, 24}) {
      const CapSector& cap = cap_sector(valence, shape);
      for (int sector = 0; sector < valence; ++sector) {
        const Eigen::MatrixXd expected = turned(cap.net(), cap.fit(), sector);
        EXPECT_LT((cap.turn(sector) * cap.fit() - expected).norm(), 1e-12 * expected.norm()) << valence;
      }
    }
  }
}

TEST(Fit, is_symmetric_under_the_reflection_that_swaps_u_and_v) {
  for (const CapShape shape : kPolynomialShapes) {
    for (const int valence : {3, 5, 8, 13, 24}) {
      const CapSector& cap = cap_sector(valence, shape);
      const RingNet& ring = cap.net();
      const Eigen::VectorXd net = Random(6).matrix<Eigen::VectorXd>(ring.size(), 1);
      Eigen::VectorXd mirrored(ring.size());
      mirrored[0] = net[0];
      for (int j = 0; j < valence; ++j) {
        for (int a = 1; a <= ring.control_rings(); ++a) {
          for (int b = 0; b <= ring.control_rings(); ++b) mirrored[ring.index(-j, b, a)] = net[ring.index(j, a, b)];
        }
      }
      const double angle = 2 * std::numbers::pi / valence, c = std::cos(angle), s = std::sin(angle);
      const Eigen::VectorXd here = cap.fit() * net, there = cap.fit() * mirrored;
      for (const auto& [x, y] : {std::pair{0.3, 0.1}, {-0.4, 0.8}, {0.9, -0.3}}) {
        EXPECT_NEAR(polynomial(there, x, y), polynomial(here, c * x + s * y, s * x - c * y), 1e-12);
      }
    }
  }
}

/// Normal equations: integral over the fitted rings of |grad b|^2 (S - Q) m = 0 for every monomial m. The integrand is
/// a polynomial of degree below 48 in each variable on each face, so that 24 points are exact; the fit's own, fewer
/// ones are not, hence the tolerance.
void expect_least_squares(CapShape shape, int valence) {
  const CapSector& cap = cap_sector(valence, shape);
  const int count = coefficient_count(shape);
  const RingNet& ring = cap.net();
  const Eigen::Matrix<double, Eigen::Dynamic, 2> characteristic = ring.characteristic_net();
  const Eigen::VectorXd net = Random(8).matrix<Eigen::VectorXd>(ring.size(), 1);
  const Eigen::VectorXd coefficients = cap.fit() * net;  // of the one polynomial, in sector 0's coordinates
  std::vector<Eigen::VectorXd> seen(valence, net);       // from each sector
  for (int sector = 0; sector < valence; ++sector) {
    for (int i = 0; i < ring.size(); ++i) seen[sector][i] = net[ring.turned(i, sector)];
  }
  Eigen::VectorXd moments = Eigen::VectorXd::Zero(count), sizes = moments;
  for (int cell = 0; cell < cell_count(shape); ++cell) {
    const int i = cell % rings(shape), j = cell / rings(shape), ring_number = ring_of(shape, cell);
    if (ring_number < fit_rings(shape, valence).first || ring_number > fit_rings(shape, valence).last) continue;
    for (const Sample& sample : tensor_rule(24)) {
      const Eigen::VectorXd here = ring.basis(sample.u + i, sample.v + j).row(0);
      const Derivatives b = tensor_blend(smoothstep_blend, sample.u + i, sample.v + j, rim(shape));
      const Eigen::Vector2d xy = characteristic.transpose() * here;
      const double weight = sample.weight * (b[1] * b[1] + b[2] * b[2]);
      for (int sector = 0; sector < valence; ++sector) {
        const double angle = 2 * std::numbers::pi * sector / valence, c = std::cos(angle), s = std::sin(angle);
        const Eigen::VectorXd tests = monomials(count, c * xy[0] - s * xy[1], s * xy[0] + c * xy[1]);
        const Eigen::VectorXd terms = weight * (here.dot(seen[sector]) - coefficients.dot(tests)) * tests;
        moments += terms;
        sizes += terms.cwiseAbs();
      }
    }
  }
  EXPECT_LT(moments.cwiseQuotient(sizes).cwiseAbs().maxCoeff(), 1e-8) << "valence " << valence;
}

TEST(FitSlow, is_orthogonal_to_its_residual_by_another_quadrature) {
  for (const CapShape shape : {CapShape::kTwoRing, CapShape::kFourRing}) {
    for (const int valence : {3, 5, 9}) expect_least_squares(shape, valence);
  }
  expect_least_squares(CapShape::kEightRing, 5);
  for (const int valence : {3, 6}) expect_least_squares(CapShape::kSixteenRing, valence);
}

}  // namespace
}  // namespace umbilic::test
