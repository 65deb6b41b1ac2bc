// SPDX-License-Identifier: MIT
/// \file
/// The Catmull-Clark step around an extraordinary vertex: spectrum, eigenvectors, limits.
#include "surface/ring_net.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "linear_algebra.h"
#include "mesh/rough_cages.h"
#include "surface/whole_basis.h"

namespace umbilic::test {
namespace {

TEST(RingNet, numbers_each_control_point_once) {
  for (const int valence : {3, 4, 7, 24}) {
    const RingNet net(valence);
    std::set<int> seen{net.index(0, 0, 0)};
    for (int j = 0; j < valence; ++j) {
      for (int a = 0; a <= net.control_rings(); ++a) {
        for (int b = 0; b <= net.control_rings(); ++b) seen.insert(net.index(j, a, b));
      }
    }
    EXPECT_EQ(static_cast<int>(seen.size()), net.size());
    EXPECT_EQ(*seen.begin(), 0);
    EXPECT_EQ(*seen.rbegin(), net.size() - 1);
    EXPECT_EQ(net.index(0, 0, 2), net.index(1, 2, 0)) << "a spoke belongs to both sectors";
    EXPECT_EQ(net.index(0, 2, -1), net.index(valence - 1, 1, 2));
    EXPECT_EQ(net.index(valence - 1, -1, 2), net.index(0, 2, 1));
  }
}

TEST(RingNet, step_keeps_constants) {
  for (int valence = 3; valence <= 24; ++valence) {
    const RingNet net(valence);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(net.size());
    EXPECT_LT((net.step() * ones - ones).cwiseAbs().maxCoeff(), 1e-14);
  }
}

/// Of the eigenvalues that are left when 1 and the subdominant one have been taken away with their eigenvectors, none
/// is larger in size than the k-th root of the norm of the k-th power.
TEST(RingNet, subdominant_eigenvalue_is_the_second_largest_and_double) {
  for (const int valence : {3, 4, 5, 8, 13}) {
    const RingNet net(valence);
    const double lambda = net.subdominant_eigenvalue();
    const Eigen::MatrixXd step = net.step(), xy = net.characteristic_net(), left = net.limit_tangents();
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(net.size());
    EXPECT_LT((product(step, ones) - ones).norm(), 1e-12);
    EXPECT_LT((product(step, xy) - lambda * xy).norm(), 1e-12);
    const Eigen::Matrix2d pairing = product(left, xy);
    EXPECT_GT(std::abs(pairing.determinant()), 0.1) << "two independent eigenvectors, and no Jordan block";
    Eigen::MatrixXd power = step - product(ones, net.limit_position());
    power -= lambda * product(product(xy, pairing.inverse()), left);
    double k = 1;
    for (; k < 512; k *= 2) power = product(power, power);
    EXPECT_LT(std::pow(power.norm(), 1 / k), lambda - 1e-2);
    EXPECT_LT(lambda, 1 - 1e-2);
  }
}

TEST(RingNet, characteristic_net_is_an_eigenvector_of_the_step) {
  for (int valence = 3; valence <= 24; ++valence) {
    const RingNet net(valence);
    const Eigen::Matrix<double, Eigen::Dynamic, 2> xy = net.characteristic_net();
    EXPECT_LT((net.step() * xy - net.subdominant_eigenvalue() * xy).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((net.basis(2, 0).row(0) * xy - Eigen::RowVector2d(1, 0)).norm(), 1e-14) << "its scale and direction";
  }
}

TEST(RingNet, characteristic_net_has_the_symmetry_of_the_polygon) {
  for (const int valence : {3, 5, 12, 24}) {
    const RingNet net(valence);
    const Eigen::Matrix<double, Eigen::Dynamic, 2> xy = net.characteristic_net();
    const Eigen::Rotation2Dd rotation(2 * std::acos(-1.0) / valence);
    for (int i = 0; i < net.size(); ++i) {
      EXPECT_LT((xy.row(net.turned(i, 1)).transpose() - rotation * xy.row(i).transpose()).norm(), 1e-13);
    }
  }
}

TEST(RingNet, characteristic_map_is_regular_and_keeps_orientation) {
  // Peters & Reif 1998 prove it for Catmull-Clark.
  for (int valence = 3; valence <= 24; ++valence) {
    const RingNet net(valence);
    const Eigen::Matrix<double, Eigen::Dynamic, 2> xy = net.characteristic_net();
    for (double u = 0; u <= 2; u += 0.25) {
      for (double v = 0; v <= 2; v += 0.25) {
        if (u + v == 0) continue;
        const Eigen::Matrix<double, kDerivativeCount, 2> jet = net.basis(u, v) * xy;
        EXPECT_GT(jet(1, 0) * jet(2, 1) - jet(1, 1) * jet(2, 0), 1e-3) << valence << " at " << u << ", " << v;
      }
    }
  }
}

TEST(RingNet, limit_weights_are_left_eigenvectors_of_1_and_the_subdominant_eigenvalue) {
  for (int valence = 3; valence <= 24; ++valence) {
    const RingNet net(valence);
    const Eigen::RowVectorXd position = net.limit_position();
    EXPECT_LT((position * net.step() - position).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_NEAR(position.sum(), 1, 1e-14);
    const Eigen::MatrixXd tangents = net.limit_tangents();
    const Eigen::MatrixXd after = tangents * net.step();
    EXPECT_LT((after - net.subdominant_eigenvalue() * tangents).cwiseAbs().maxCoeff(), 1e-13) << "valence " << valence;
    EXPECT_LT(tangents.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(RingNet, basis_tends_to_the_limit_position) {
  for (const int valence : {3, 5, 12}) {
    const RingNet net(valence);
    // The distance shrinks like lambda^k, here at least 0.41^20 and at most 0.65^30.
    const Eigen::RowVectorXd near = net.basis(std::ldexp(1.0, -60), std::ldexp(0.7, -60)).row(0);
    EXPECT_LT((near - net.limit_position()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(RingNet, cross_product_of_limit_tangents_points_to_the_side_that_sees_sectors_counterclockwise) {
  for (const int valence : {3, 5, 12, 24}) {
    const RingNet net(valence);
    Points points(net.size(), 3);
    points << net.characteristic_net(), Eigen::VectorXd::Zero(net.size());
    const Eigen::Matrix<double, 2, 3> tangents = net.limit_tangents() * points;
    const Eigen::RowVector3d normal = tangents.row(0).cross(tangents.row(1));
    EXPECT_GT(normal.z(), 0);
    EXPECT_NEAR(normal.x(), 0, 1e-13);
    EXPECT_NEAR(normal.y(), 0, 1e-13);
  }
}

TEST(RingNet, of_valence_4_is_the_bicubic_bspline) {
  // Its basis reproduces x = u, y = v, and their products over the grid.
  const RingNet net(4);
  Eigen::Matrix<double, Eigen::Dynamic, 3> grid(net.size(), 3);
  for (int j = 0; j < 4; ++j) {
    for (int a = 0; a <= net.control_rings(); ++a) {
      for (int b = 0; b <= net.control_rings(); ++b) {
        double x = a, y = b;
        for (int turn = 0; turn < j; ++turn) x = -std::exchange(y, x);
        grid.row(net.index(j, a, b)) << x, y, x * y;
      }
    }
  }
  for (const auto& [u, v] : {std::pair{0.1, 0.2}, {0.7, 1.6}, {1.2, 0.03}}) {
    const Eigen::Matrix<double, kDerivativeCount, 3> jet = net.basis(u, v) * grid;
    Eigen::Matrix<double, kDerivativeCount, 3> expected;
    expected.setZero();
    expected.topRows(3) << u, v, u * v, 1, 0, v, 0, 1, u;
    expected(derivative_index(1, 1), 2) = 1;
    EXPECT_LT((jet - expected).cwiseAbs().maxCoeff(), 1e-11);  // four halvings at most
  }
}

}  // namespace
}  // namespace umbilic::test
