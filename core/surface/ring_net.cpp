// SPDX-License-Identifier: MIT
/// \file
/// Catmull-Clark rules on the ring net, and what follows from them near its centre.
#include "surface/ring_net.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "surface/bspline.h"

namespace umbilic {
namespace {

constexpr int kPerSector = RingNet::kRings * (RingNet::kRings + 1);

}  // namespace

RingNet::RingNet(int valence) : valence_(valence), step_(12 * valence + 1, 12 * valence + 1) {
  assert(valence >= 3);
  build_step();
  build_limit_tangents();
}

int RingNet::index(int sector, int a, int b) const {
  if (b < 0) return index(sector - 1, -b, a);
  if (a < 0) return index(sector + 1, b, -a);
  if (a == 0) return b == 0 ? 0 : index(sector + 1, b, 0);
  assert(a <= kRings && b <= kRings);
  const int wrapped = (sector % valence_ + valence_) % valence_;
  return 1 + wrapped * kPerSector + (a - 1) * (kRings + 1) + b;
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
    for (int a = 1; a <= kRings; ++a) {
      for (int b = 0; b <= kRings; ++b) {
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

DerivativeRows RingNet::regular_basis(double u, double v) const {
  const int i = std::min(static_cast<int>(u), kRings - 2), j = std::min(static_cast<int>(v), kRings - 2);
  assert(i + j > 0);
  const Eigen::Matrix4d along_u = cubic_bspline(u - i), along_v = cubic_bspline(v - j);
  DerivativeRows rows = DerivativeRows::Zero(kDerivativeCount, size());
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      const int column = index(0, i + a - 1, j + b - 1);
      for (int d = 0; d < kDerivativeCount; ++d) rows(d, column) += along_u(kOrderU[d], a) * along_v(kOrderV[d], b);
    }
  }
  return rows;
}

DerivativeRows RingNet::basis(double u, double v) const {
  assert(u >= 0 && v >= 0 && std::max(u, v) > 0 && std::max(u, v) <= 2);
  int steps = 0;
  for (; std::max(u, v) < 1; ++steps) {
    u *= 2;
    v *= 2;
  }
  DerivativeRows rows = regular_basis(u, v);
  for (int s = 0; s < steps; ++s) {
    // rows * step, past the many columns that are still zero.
    DerivativeRows finer = DerivativeRows::Zero(kDerivativeCount, size());
    for (int i = 0; i < size(); ++i) {
      if ((rows.col(i).array() == 0).all()) continue;
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(step_, i); entry; ++entry) {
        finer.col(entry.index()) += entry.value() * rows.col(i);
      }
    }
    rows.swap(finer);
  }
  for (int d = 0; d < kDerivativeCount; ++d) rows.row(d) *= std::ldexp(1.0, steps * (kOrderU[d] + kOrderV[d]));
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
    for (int a = 1; a <= kRings; ++a) {
      for (int b = 0; b <= kRings; ++b) {
        net.row(index(j, a, b)) << a * std::cos(j * angle) + b * std::cos((j + 1) * angle),
            a * std::sin(j * angle) + b * std::sin((j + 1) * angle);
      }
    }
  }
  // The start has the symmetry of the eigenvector; within it the other eigenvalues are less than half as large.
  constexpr int kPowerIterations = 64;
  for (int i = 0; i < kPowerIterations; ++i) {
    net = (step_ * net / subdominant_eigenvalue()).eval();
    net.rowwise() -= net.row(0).eval();  // the constant mode, which round-off would let grow
  }
  const double scale = (basis(2, 0).row(0) * net)(0, 0);
  return net / scale;
}

}  // namespace umbilic
