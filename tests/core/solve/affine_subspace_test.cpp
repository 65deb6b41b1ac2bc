// SPDX-License-Identifier: MIT
/// \file
/// Solutions of linear equations: against dense linear algebra, with rows that repeat or contradict each other, in any
/// order and scale.
#include "solve/affine_subspace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <random>

#include "linear_algebra.h"

namespace umbilic {
namespace {

using Dense = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return 2.0 * engine_() / std::mt19937::max() - 1; }
  int below(int n) { return static_cast<int>(engine_() % n); }
  Vector vector(Eigen::Index n) {
    Vector v(n);
    for (double& x : v) x = (*this)();
    return v;
  }

 private:
  std::mt19937 engine_;
};

LinearRows rows_of(const Dense& a, const Vector& b) {
  LinearRows rows{a.sparseView(), b, Vector::Ones(b.size())};
  return rows;
}

/// Independent rows of five neighbouring entries each, so that they share unknowns.
Dense sparse_rows(int rows, int unknowns, Random& random) {
  Dense a = Dense::Zero(rows, unknowns);
  for (int i = 0; i < rows; ++i) {
    const int first = i * (unknowns - 5) / rows;
    for (int k = 0; k < 5; ++k) a(i, first + k) = random();
  }
  return a;
}

/// Rows in another order.
LinearRows permuted(const LinearRows& rows, const std::vector<int>& order) {
  const Dense a = rows.matrix;
  LinearRows result = rows;
  Dense b = a;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    b.row(k) = a.row(order[i]);
    result.right[k] = rows.right[order[i]];
    result.scales[k] = rows.scales[order[i]];
  }
  result.matrix = b.sparseView();
  return result;
}

std::vector<int> shuffled(int count, Random& random) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (int i = count - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
  return order;
}

/// The orthogonal projection to the directions with A d = 0.
Dense tangent_projection(const Dense& a, double cutoff = 1e-9) {
  Dense q(a.cols(), 0);
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    Vector v = a.row(i).transpose().normalized();
    for (int pass = 0; pass < 2; ++pass) v -= q * (q.transpose() * v);
    if (v.norm() < cutoff) continue;
    q.conservativeResize(Eigen::NoChange, q.cols() + 1);
    q.rightCols(1) = v.normalized();
  }
  return Dense::Identity(a.cols(), a.cols()) - q * q.transpose();
}

Dense projection_of(const Dense& basis) { return basis * test::solve(basis.transpose() * basis, basis.transpose()); }

TEST(AffineSubspace, holds_all_solutions_and_nothing_else) {
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Dense a = sparse_rows(18, 40, random);
    const Vector start = random.vector(40), truth = random.vector(40);
    const AffineSubspace solutions(rows_of(a, a * truth), start);
    ASSERT_TRUE(solutions.contradiction().empty());
    ASSERT_TRUE(solutions.orthonormal());
    const Dense n = solutions.basis();
    EXPECT_LT((n.transpose() * n - Dense::Identity(n.cols(), n.cols())).norm(), 1e-13);
    const Dense tangent = tangent_projection(a);
    EXPECT_LT((n * n.transpose() - tangent).norm(), 1e-9) << "conditions of random rows reach 1e5";
    EXPECT_NEAR(tangent.trace(), solutions.dimension(), 1e-9);
    const Vector y = random.vector(n.cols());
    EXPECT_LT((a * solutions.point(y) - a * truth).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((solutions.coordinates(solutions.point(y)) - y).norm(), 1e-10);
    EXPECT_LT((solutions.origin() - (truth + tangent * (start - truth))).norm(), 1e-9) << "the nearest to the start";
  }
}

TEST(AffineSubspace, of_unknowns_without_rows_is_all_of_space) {
  const Vector start = Random(2).vector(7);
  const AffineSubspace solutions(rows_of(Dense(0, 7), Vector(0)), start);
  EXPECT_EQ(Dense(solutions.basis()), Dense::Identity(7, 7));
  EXPECT_EQ(solutions.origin(), start);
  EXPECT_EQ(solutions.multipliers(start).size(), 0);
  EXPECT_EQ(solutions.kept(Dense::Identity(7, 2)).cols(), 2);
}

TEST(AffineSubspace, leaves_unit_columns_to_unknowns_that_no_row_touches) {
  Dense a = Dense::Zero(1, 6);
  a.row(0) << 0, 1, 0, 4, 1, 0;
  const AffineSubspace solutions(rows_of(a, Vector::Ones(1)), Vector::Zero(6));
  const Dense n = solutions.basis();
  ASSERT_EQ(n.cols(), 5);
  for (const int untouched : {0, 2, 5}) {
    EXPECT_EQ(n.row(untouched).cwiseAbs().sum(), 1);
    EXPECT_EQ(n.row(untouched).maxCoeff(), 1);
  }
  EXPECT_EQ((n.array() != 0).count(), 3 + 3 * 2) << "a row of 3 unknowns makes a block of 3 x 2";
}

TEST(AffineSubspace, drops_rows_that_follow_from_others) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Dense a = sparse_rows(12, 30, random);
    const Vector truth = random.vector(30);
    const AffineSubspace alone(rows_of(a, a * truth), truth);
    ASSERT_TRUE(alone.redundant().empty());
    a.conservativeResize(15, Eigen::NoChange);
    a.row(12) = 2 * a.row(3) - a.row(7);
    a.row(13) = -a.row(5);
    a.row(14) = a.row(12) + 3 * a.row(13) + a.row(0);
    const AffineSubspace all(rows_of(a, a * truth), truth);
    EXPECT_TRUE(all.contradiction().empty());
    EXPECT_EQ(all.redundant(), (std::vector<int>{12, 13, 14}));
    EXPECT_LT((Dense(all.basis() * all.basis().transpose()) - tangent_projection(a)).norm(), 1e-9);
  }
}

TEST(AffineSubspace, takes_six_rows_on_four_unknowns_as_four) {
  // Position, tangent and curvature held at both ends of four points across a strip of one edge.
  Dense a = Dense::Zero(6, 4);
  a.row(0) << 1, 4, 1, 0;
  a.row(1) << -1, 0, 1, 0;
  a.row(2) << 1, -2, 1, 0;
  a.row(3) << 0, 1, 4, 1;
  a.row(4) << 0, -1, 0, 1;
  a.row(5) << 0, 1, -2, 1;
  const Vector truth = Random(4).vector(4);
  const AffineSubspace solutions(rows_of(a, a * truth), Vector::Zero(4));
  EXPECT_EQ(solutions.redundant(), (std::vector<int>{4, 5}));
  EXPECT_EQ(solutions.dimension(), 0);
  EXPECT_LT((solutions.origin() - truth).norm(), 1e-14);
}

TEST(AffineSubspace, names_a_smallest_contradiction) {
  Random random(5);
  for (int trial = 0; trial < 30; ++trial) {
    Dense a = sparse_rows(12, 30, random);
    a.conservativeResize(14, Eigen::NoChange);
    a.row(12) = a.row(2) - 2 * a.row(9) + a.row(4);
    a.row(13) = a.row(12) + a.row(11);
    Vector b = a * random.vector(30);
    b[12] += 1e-6;
    b[13] += 1e-6;
    const std::vector<int> order = shuffled(14, random);
    const AffineSubspace solutions(permuted(rows_of(a, b), order), Vector::Zero(30));
    std::vector<int> set;
    for (const int row : solutions.contradiction()) set.push_back(order[row]);
    std::sort(set.begin(), set.end());
    EXPECT_TRUE(std::is_sorted(solutions.contradiction().begin(), solutions.contradiction().end()));
    ASSERT_FALSE(set.empty());
    for (std::size_t without = 0; without <= set.size(); ++without) {
      Dense rest(0, 30);
      Vector right(0);
      for (std::size_t i = 0; i < set.size(); ++i) {
        if (i == without) continue;
        rest.conservativeResize(rest.rows() + 1, Eigen::NoChange);
        right.conservativeResize(right.size() + 1);
        rest.bottomRows(1) = a.row(set[i]);
        right[right.size() - 1] = b[set[i]];
      }
      const bool consistent = AffineSubspace(rows_of(rest, right), Vector::Zero(30)).contradiction().empty();
      EXPECT_EQ(consistent, without < set.size()) << "without row " << without;
    }
  }
}

TEST(AffineSubspace, names_the_smaller_of_two_contradictions) {
  Random random(6);
  Dense a = sparse_rows(10, 30, random);
  a.conservativeResize(12, Eigen::NoChange);
  a.row(10) = a.row(0) + a.row(1) + a.row(2);
  a.row(11) = 2 * a.row(7);
  Vector b = a * random.vector(30);
  b.tail(2).array() += 0.1;
  EXPECT_EQ(AffineSubspace(rows_of(a, b), Vector::Zero(30)).contradiction(), (std::vector<int>{7, 11}));
}

TEST(AffineSubspace, takes_rows_of_rounding_errors_for_zero) {
  Dense a = Dense::Zero(3, 4);
  a.row(0) << 1, 0, 0, 1;
  a.row(1) << 1e-17, -2e-17, 0, 0;
  const AffineSubspace held(rows_of(a, Vector::Zero(3)), Vector::Ones(4));
  EXPECT_EQ(held.redundant(), (std::vector<int>{1, 2}));
  EXPECT_EQ(held.dimension(), 3);
  const AffineSubspace moved(rows_of(a, Vector::Unit(3, 1)), Vector::Ones(4));
  EXPECT_EQ(moved.contradiction(), (std::vector<int>{1})) << "0 = 1";
}

TEST(AffineSubspace, does_not_depend_on_the_order_or_the_scale_of_the_rows) {
  Random random(7);
  for (int trial = 0; trial < 10; ++trial) {
    Dense a = sparse_rows(12, 30, random);
    a.conservativeResize(14, Eigen::NoChange);
    a.row(12) = a.row(1) + a.row(2);
    a.row(13) = a.row(5) - a.row(6);
    const Vector start = random.vector(30);
    const LinearRows rows = rows_of(a, a * random.vector(30));
    LinearRows other = permuted(rows, shuffled(14, random));
    for (int i = 0; i < 14; ++i) {
      const double factor = std::pow(10, 8 * random());
      other.matrix.row(i) *= factor;
      other.right[i] *= factor;
      other.scales[i] *= std::abs(factor);
    }
    const AffineSubspace first(rows, start), second(other, start);
    EXPECT_LT((first.origin() - second.origin()).norm(), 1e-10);
    EXPECT_LT(
        (Dense(first.basis() * first.basis().transpose()) - Dense(second.basis() * second.basis().transpose())).norm(),
        1e-9);
    EXPECT_EQ(first.redundant().size(), second.redundant().size());
    const AffineSubspace again(rows, start);
    EXPECT_EQ(first.origin(), again.origin()) << "to the last bit";
    EXPECT_EQ(Dense(first.basis()), Dense(again.basis())) << "to the last bit";
  }
}

/// 1 4 1 along a line: each row shares unknowns with its neighbours, so that all are one cluster.
LinearRows spline_rows(int count, const std::vector<int>& order, Random& random, Vector& truth) {
  truth = random.vector(count + 2);
  LinearRows rows{{count, count + 2}, Vector(count), Vector::Ones(count)};
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) entries.emplace_back(i, order[i] + k, (k == 1 ? 4 : 1) / 6.);
  }
  rows.matrix.setFromTriplets(entries.begin(), entries.end());
  rows.right = rows.matrix * truth;
  return rows;
}

TEST(AffineSubspace, of_a_large_cluster_is_sparse_and_exact) {
  Random random(8);
  const int count = 400;
  for (const bool sorted : {true, false}) {
    std::vector<int> order = shuffled(count, random);
    if (sorted) std::sort(order.begin(), order.end());
    Vector truth;
    const LinearRows rows = spline_rows(count, order, random, truth);
    const Vector start = random.vector(count + 2);
    const AffineSubspace solutions(rows, start);
    EXPECT_FALSE(solutions.orthonormal());
    ASSERT_EQ(solutions.dimension(), 2);
    const Dense n = solutions.basis();
    EXPECT_LT((rows.matrix * n).cwiseAbs().maxCoeff(), 1e-15);
    const Vector y = random.vector(2);
    EXPECT_LT((rows.matrix * solutions.point(y) - rows.right).cwiseAbs().maxCoeff(), 2e-15);
    EXPECT_LT((solutions.coordinates(solutions.point(y)) - y).norm(), 1e-12);
    EXPECT_LT((solutions.origin() - truth - projection_of(n) * (start - truth)).norm(), 1e-12);
  }
}

TEST(AffineSubspace, takes_linear_time) {
  const auto seconds = [](int count, bool chain) {
    Random random(9);
    std::vector<int> order = shuffled(count, random);
    Vector truth;
    LinearRows rows = spline_rows(count, order, random, truth);
    if (!chain) {  // the same rows apart: position and tangent across a boundary
      std::vector<Eigen::Triplet<double>> entries;
      for (int i = 0; i < count; ++i) {
        for (int k = 0; k < 3; ++k) entries.emplace_back(i, 3 * (i / 2) + k, i % 2 == 0 ? (k == 1 ? 4 : 1) : k - 1);
      }
      rows.matrix.resize(count, 3 * count);
      rows.matrix.setFromTriplets(entries.begin(), entries.end());
    }
    const Vector start = random.vector(rows.matrix.cols());
    const std::clock_t begin = std::clock();
    const AffineSubspace solutions(rows, start);
    EXPECT_TRUE(solutions.contradiction().empty());
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  // 0.02 s each. A large bound, because machines differ and sanitizers slow down; quadratic time would take minutes.
  EXPECT_LT(seconds(10000, true), 5);
  EXPECT_LT(seconds(10000, false), 5);
}

TEST(AffineSubspace, multipliers_are_the_derivatives_of_the_minimum_by_the_right_sides) {
  Random random(10);
  const int n = 20;
  Dense a = sparse_rows(7, n, random);
  for (int i = 0; i < 6; ++i) a.row(i) *= std::pow(10, i - 3);
  a.row(6) = a.row(0) - 2 * a.row(1);
  const Vector truth = random.vector(n);
  Dense square = Dense::NullaryExpr(n, n, [&] { return random(); });
  square = square * square.transpose() + Dense::Identity(n, n);
  const Vector linear = random.vector(n);
  const auto minimum = [&](const Vector& b) {
    const AffineSubspace solutions(rows_of(a, b), Vector::Zero(n));
    const Dense basis = solutions.basis();
    const Vector gradient = basis.transpose() * (square * solutions.origin() + linear);
    const Vector q = solutions.point(-test::solve(basis.transpose() * square * basis, gradient));
    return std::pair<double, Vector>(0.5 * q.dot(square * q) + linear.dot(q), square * q + linear);
  };
  Vector b = a * truth;
  b[6] = b[0] - 2 * b[1];
  const Vector lambda = AffineSubspace(rows_of(a, b), truth).multipliers(minimum(b).second);
  EXPECT_EQ(lambda[6], 0) << "dropped";
  for (int i = 0; i < 6; ++i) {
    const double h = 1e-3 * a.row(i).norm();  // the minimum is quadratic in b: central differences are exact
    Vector more = b, less = b;
    more[i] += h;
    less[i] -= h;
    for (Vector* changed : {&more, &less}) (*changed)[6] = (*changed)[0] - 2 * (*changed)[1];
    const double expected = (minimum(more).first - minimum(less).first) / (2 * h);
    EXPECT_NEAR(lambda[i], expected, 1e-8 * std::abs(expected) + 1e-9 / a.row(i).norm()) << i;
  }
}

TEST(AffineSubspace, keeps_the_directions_along_all_rows) {
  // The four corners of a square, the first held: of translations and the rotation only that about it is left.
  Dense directions = Dense::Zero(8, 3);
  const double x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 1, 1};
  for (int v = 0; v < 4; ++v) {
    directions(2 * v, 0) = directions(2 * v + 1, 1) = 1;
    directions(2 * v, 2) = 0.5 - y[v];
    directions(2 * v + 1, 2) = x[v] - 0.5;
  }
  Dense a = Dense::Zero(2, 8);
  a(0, 0) = a(1, 1) = 1;
  const AffineSubspace held(rows_of(a, Vector::Zero(2)), Vector::Zero(8));
  const Dense kept = held.kept(directions);
  ASSERT_EQ(kept.cols(), 1);
  EXPECT_LT((a * kept).norm(), 1e-15);
  Vector about(8);
  for (int v = 0; v < 4; ++v) about.segment<2>(2 * v) << -y[v], x[v];
  EXPECT_NEAR(std::abs(kept.col(0).dot(about.normalized())), 1, 1e-14);

  Dense repeated(8, 4);
  repeated << directions, directions.col(2);
  EXPECT_EQ(held.kept(repeated).cols(), 1) << "directions that depend on others count once";
  a.conservativeResize(3, Eigen::NoChange);
  a.row(2).setZero();
  a(2, 3) = 1;
  EXPECT_EQ(AffineSubspace(rows_of(a, Vector::Zero(3)), Vector::Zero(8)).kept(directions).cols(), 0);
}

}  // namespace
}  // namespace umbilic
