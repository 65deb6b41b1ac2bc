// SPDX-License-Identifier: MIT
/// \file
/// Catmull-Clark rules on the ring net, and the limit surface near its centre that follows from them.
#include "surface/ring_net.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "surface/bspline.h"

namespace umbilic {
namespace {

/// Number of powers of the step that are stored. Graded rules rarely need more.
constexpr int kKeptRefinements = 5;

/// Index of a value in a sorted list.
int index_in(const std::vector<int>& sorted, int value) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

}  // namespace

RingNet::RingNet(int valence, int rings) : valence_(valence), rings_(rings), step_(size(), size()) {
  assert(valence >= 3 && rings >= 2);
  build_step();
  build_limit_tangents();
  build_refinements();
}

int RingNet::index(int sector, int a, int b) const {
  if (b < 0) return index(sector - 1, -b, a);
  if (a < 0) return index(sector + 1, b, -a);
  if (a == 0) return b == 0 ? 0 : index(sector + 1, b, 0);
  assert(a <= control_rings() && b <= control_rings());
  const int wrapped = (sector % valence_ + valence_) % valence_, per_spoke = control_rings() + 1;
  return 1 + (wrapped * control_rings() + a - 1) * per_spoke + b;
}

int RingNet::turned(int i, int sector) const {
  const int others = size() - 1;
  return i == 0 ? 0 : 1 + (i - 1 + sector * (others / valence_)) % others;
}

void RingNet::build_step() {
  std::vector<Eigen::Triplet<double>> entries;
  const double n = valence_;
  entries.emplace_back(0, 0, 1 - 7 / (4 * n));
  for (int j = 0; j < valence_; ++j) {
    entries.emplace_back(0, index(j, 1, 0), 3 / (2 * n * n));
    entries.emplace_back(0, index(j, 1, 1), 1 / (4 * n * n));
  }
  // The cubic B-spline refinement masks in one direction: even points 1 6 1, odd points 4 4, over 8.
  const auto masks = [](int a) {
    return a % 2 == 0 ? std::vector<std::pair<int, double>>{{a / 2 - 1, 1 / 8.}, {a / 2, 6 / 8.}, {a / 2 + 1, 1 / 8.}}
                      : std::vector<std::pair<int, double>>{{a / 2, 4 / 8.}, {a / 2 + 1, 4 / 8.}};
  };
  for (int j = 0; j < valence_; ++j) {
    for (int a = 1; a <= control_rings(); ++a) {
      for (int b = 0; b <= control_rings(); ++b) {
        for (const auto& [p, along_u] : masks(a)) {
          for (const auto& [q, along_v] : masks(b)) {
            entries.emplace_back(index(j, a, b), index(j, p, q), along_u * along_v);
          }
        }
      }
    }
  }
  step_.setFromTriplets(entries.begin(), entries.end());
}

void RingNet::build_refinements() {
  const int cells = rings_ * rings_;
  std::vector<std::array<int, 16>> points(cells);
  support_.resize(cells);
  grids_.resize(cells);
  for (int cell = 1; cell < cells; ++cell) {
    for (int i = 0; i < 16; ++i) points[cell][i] = index(0, cell % rings_ + i % 4 - 1, cell / rings_ + i / 4 - 1);
    support_[cell].assign(points[cell].begin(), points[cell].end());
    std::sort(support_[cell].begin(), support_[cell].end());
    for (int i = 0; i < 16; ++i) grids_[cell][i] = index_in(support_[cell], points[cell][i]);
  }
  // The support of cell 0: the points from which one step computes the control points of the three cells next to it. A
  // step computes these points from one another, so powers of the step can be restricted to them.
  const std::array<int, 3> next{1, rings_, rings_ + 1};
  std::vector<int>& near = support_[0];
  for (const int cell : next) {
    for (const int row : points[cell]) {
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(step_, row); entry; ++entry) {
        near.push_back(static_cast<int>(entry.index()));
      }
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  const auto rows_of = [&](const auto& rows) {
    Rows result = Rows::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(near.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(step_, rows[i]); entry; ++entry) {
        result(static_cast<Eigen::Index>(i), index_in(near, static_cast<int>(entry.index()))) = entry.value();
      }
    }
    return result;
  };
  step_near_ = rows_of(near);
  refined_.resize(kKeptRefinements);
  for (std::size_t k = 0; k < next.size(); ++k) {
    refined_[0][k] = rows_of(points[next[k]]);
    for (int n = 1; n < kKeptRefinements; ++n) refined_[n][k] = refined_[n - 1][k] * step_near_;
  }
}

DerivativeRows RingNet::face_basis(int cell, double u, double v) const {
  assert(u >= 0 && v >= 0 && std::max(u, v) <= 1 && (cell > 0 || std::max(u, v) > 0));
  int steps = 0, next = 0;
  if (cell == 0) {
    for (; std::max(u, v) <= 1; ++steps) {
      u *= 2;
      v *= 2;
    }
    const int i = std::min(static_cast<int>(u), 1), j = std::min(static_cast<int>(v), 1);
    next = i + 2 * j - 1;
    u -= i;
    v -= j;
  }
  const Eigen::Matrix4d along_u = cubic_bspline(u), along_v = cubic_bspline(v);
  if (steps == 0) {
    DerivativeRows rows(kDerivativeCount, 16);
    for (int i = 0; i < 16; ++i) {
      for (int d = 0; d < kDerivativeCount; ++d) {
        rows(d, grids_[cell][i]) = along_u(kOrderU[d], i % 4) * along_v(kOrderV[d], i / 4);
      }
    }
    return rows;
  }
  // Applies the basis in v to the control points, then the basis in u; all are functions of the support.
  const int kept = std::min(steps, kKeptRefinements);
  const Rows& points = refined_[kept - 1][next];
  const Eigen::Index count = points.cols();
  Eigen::Matrix<double, kDerivativeCount, Eigen::Dynamic, Eigen::RowMajor> rows(kDerivativeCount, count);
  Eigen::Matrix<double, 4, Eigen::Dynamic, Eigen::RowMajor> along(4, count);
  for (int l = 0; l < 4; ++l) {
    for (int a = 0; a < 4; ++a) {
      along.row(a) = along_v(l, 0) * points.row(a) + along_v(l, 1) * points.row(4 + a) +
                     along_v(l, 2) * points.row(8 + a) + along_v(l, 3) * points.row(12 + a);
    }
    for (int k = 0; k + l < 4; ++k) {
      rows.row(derivative_index(k, l)) =
          std::ldexp(1.0, steps * (k + l)) * (along_u(k, 0) * along.row(0) + along_u(k, 1) * along.row(1) +
                                              along_u(k, 2) * along.row(2) + along_u(k, 3) * along.row(3));
    }
  }
  for (int s = kept; s < steps; ++s) rows = (rows * step_near_).eval();
  return rows;
}

DerivativeRows RingNet::basis(double u, double v) const {
  const int i = std::min(static_cast<int>(u), rings_ - 1), j = std::min(static_cast<int>(v), rings_ - 1);
  const int cell = i + rings_ * j;
  const DerivativeRows near = face_basis(cell, u - i, v - j);
  DerivativeRows rows = DerivativeRows::Zero(kDerivativeCount, size());
  for (Eigen::Index c = 0; c < near.cols(); ++c) rows.col(support_[cell][c]) = near.col(c);
  return rows;
}

Eigen::RowVectorXd RingNet::limit_position() const {
  const double n = valence_;
  Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(size());
  weights[0] = n / (n + 5);
  for (int j = 0; j < valence_; ++j) {
    weights[index(j, 1, 0)] = 4 / (n * (n + 5));
    weights[index(j, 1, 1)] = 1 / (n * (n + 5));
  }
  return weights;
}

void RingNet::build_limit_tangents() {
  const double angle = 2 * std::numbers::pi / valence_;
  const double edge = 1 + std::cos(angle) + std::cos(angle / 2) * std::sqrt(2 * (9 + std::cos(angle)));
  auto& weights = limit_tangents_;
  weights.setZero(2, size());
  for (int j = 0; j < valence_; ++j) {
    weights.col(index(j, 1, 0)) << edge * std::cos(j * angle), edge * std::sin(j * angle);
    weights.col(index(j, 1, 1)) << std::cos(j * angle) + std::cos((j + 1) * angle),
        std::sin(j * angle) + std::sin((j + 1) * angle);
  }
}

double RingNet::subdominant_eigenvalue() const {
  const double c = std::cos(2 * std::numbers::pi / valence_);
  return (5 + c + std::sqrt((9 + c) * (1 + c))) / 16;
}

Eigen::Matrix<double, Eigen::Dynamic, 2> RingNet::characteristic_net() const {
  const double angle = 2 * std::numbers::pi / valence_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> net(size(), 2);
  net.row(0).setZero();
  for (int j = 0; j < valence_; ++j) {
    for (int a = 1; a <= control_rings(); ++a) {
      for (int b = 0; b <= control_rings(); ++b) {
        net.row(index(j, a, b)) << a * std::cos(j * angle) + b * std::cos((j + 1) * angle),
            a * std::sin(j * angle) + b * std::sin((j + 1) * angle);
      }
    }
  }
  // The start has the rotational symmetry of the eigenvector. Among vectors with this symmetry, the next eigenvalue is
  // less than half as large, so the power iteration converges fast.
  constexpr int kPowerIterations = 64;
  for (int i = 0; i < kPowerIterations; ++i) {
    net = (step_ * net / subdominant_eigenvalue()).eval();
    net.rowwise() -= net.row(0).eval();  // removes the constant mode, which round-off would amplify
  }
  const double scale = (basis(2, 0).row(0) * net)(0, 0);
  return net / scale;
}

}  // namespace umbilic
