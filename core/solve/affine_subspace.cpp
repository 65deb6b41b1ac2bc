// SPDX-License-Identifier: MIT
/// \file
/// Scales and eliminates the rows, and makes a basis of each cluster's null space.
#include "solve/affine_subspace.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "base/symmetric_eigen.h"
#include "solve/row_elimination.h"

namespace umbilic {
namespace {

constexpr double kKeptDirection = 1e-6;
constexpr double kShift = 1e-14;
constexpr int kRefinements = 6;

/// The sets of unknowns that rows connect.
class Clusters {
 public:
  explicit Clusters(int unknowns) : parent_(unknowns) { std::iota(parent_.begin(), parent_.end(), 0); }

  int of(int unknown) {
    while (parent_[unknown] != unknown) unknown = parent_[unknown] = parent_[parent_[unknown]];
    return unknown;
  }
  void join(int a, int b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<int> parent_;
};

/// Orthonormal columns orthogonal to those of `columns`, which are independent, by Householder's reflections. Where the
/// leading square part of `columns` dominates, column k of the result is nearly the unit vector columns.cols() + k.
Eigen::MatrixXd complement(Eigen::MatrixXd columns) {
  const Eigen::Index n = columns.rows(), rank = columns.cols();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n - rank);
  result.bottomRows(n - rank).setIdentity();
  Eigen::VectorXd factors(rank);
  for (Eigen::Index k = 0; k < rank; ++k) {
    auto v = columns.col(k).tail(n - k);
    v[0] += std::copysign(v.norm(), v[0]);
    factors[k] = 2 / v.squaredNorm();
    for (Eigen::Index j = k + 1; j < rank; ++j) {
      auto other = columns.col(j).tail(n - k);
      other -= factors[k] * v.dot(other) * v;
    }
  }
  for (Eigen::Index k = rank - 1; k >= 0; --k) {
    const auto v = columns.col(k).tail(n - k);
    for (Eigen::Index j = 0; j < n - rank; ++j) {
      auto column = result.col(j).tail(n - k);
      column -= factors[k] * v.dot(column) * v;
    }
  }
  return result;
}

}  // namespace

AffineSubspace::AffineSubspace(LinearRows rows, const Eigen::VectorXd& start) : rows_(std::move(rows)) {
  assert(rows_.right.size() == rows_.count() && rows_.scales.size() == rows_.count());
  assert(rows_.matrix.cols() == start.size());
  eliminate();
  if (contradiction_.empty()) origin_ = nearest(start);
}

void AffineSubspace::eliminate() {
  RowElimination elimination(static_cast<int>(rows_.matrix.cols()));
  lengths_.resize(rows_.count());
  SparseEntries entries;
  for (int i = 0; i < rows_.count(); ++i) {
    double length = rows_.matrix.cols() > 0 ? rows_.matrix.row(i).norm() : 0;
    if (length <= RowElimination::kDependent * rows_.scales[i]) length = rows_.scales[i];
    lengths_[i] = length;
    rows_.matrix.row(i) /= length;
    rows_.right[i] /= length;
    rows_.scales[i] /= length;
    entries.clear();
    for (decltype(rows_.matrix)::InnerIterator it(rows_.matrix, i); it; ++it) {
      if (it.value() != 0) entries.push_back({static_cast<int>(it.col()), it.value()});
    }
    if (elimination.add(entries)) {
      independent_.push_back(i);
      continue;
    }
    double gap = rows_.right[i], scale = rows_.scales[i];
    std::vector<int> circuit;
    for (const auto& [row, factor] : elimination.combination()) {
      const int j = independent_[row];
      gap -= factor * rows_.right[j];
      scale += std::abs(factor) * rows_.scales[j];
      circuit.push_back(j);
    }
    circuit.push_back(i);
    if (std::abs(gap) <= kConsistent * scale) {
      redundant_.push_back(i);
    } else if (contradiction_.empty() || circuit.size() < contradiction_.size()) {
      contradiction_ = std::move(circuit);
    }
  }
  if (!contradiction_.empty()) return;

  matrix_.resize(elimination.rank(), rows_.matrix.cols());
  right_.resize(elimination.rank());
  std::vector<Eigen::Triplet<double>> kept;
  for (int row = 0; row < elimination.rank(); ++row) {
    right_[row] = rows_.right[independent_[row]];
    for (decltype(rows_.matrix)::InnerIterator it(rows_.matrix, independent_[row]); it; ++it) {
      kept.emplace_back(row, static_cast<int>(it.col()), it.value());
    }
  }
  matrix_.setFromTriplets(kept.begin(), kept.end());
  if (elimination.rank() > 0) {
    const Eigen::SparseMatrix<double> columns = matrix_.transpose();
    Eigen::SparseMatrix<double> products = matrix_ * columns;
    // Rows that are nearly dependent stay positive definite; every user of the factors repeats to rounding.
    for (int row = 0; row < elimination.rank(); ++row) products.coeffRef(row, row) += kShift;
    [[maybe_unused]] const bool positive = products_.factor(products.triangularView<Eigen::Lower>());
    assert(positive);
  }
  build_basis(elimination);
}

void AffineSubspace::build_basis(const RowElimination& elimination) {
  const int unknowns = static_cast<int>(matrix_.cols());
  Clusters clusters(unknowns);
  for (int row = 0; row < elimination.rank(); ++row) {
    for (decltype(matrix_)::InnerIterator it(matrix_, row); it; ++it) {
      clusters.join(elimination.pivot(row), static_cast<int>(it.col()));
    }
  }
  struct Cluster {
    std::vector<int> rows, unknowns;  // the unknowns are first the pivots of the rows, then the free ones
  };
  std::vector<Cluster> members(unknowns);
  for (int row = 0; row < elimination.rank(); ++row) {
    Cluster& cluster = members[clusters.of(elimination.pivot(row))];
    cluster.rows.push_back(row);
    cluster.unknowns.push_back(elimination.pivot(row));
  }
  std::vector<int> column(unknowns, -1);
  for (int unknown = 0; unknown < unknowns; ++unknown) {
    if (elimination.is_pivot(unknown)) continue;
    column[unknown] = static_cast<int>(free_unknown_.size());
    free_unknown_.push_back(-1);
    members[clusters.of(unknown)].unknowns.push_back(unknown);
  }

  const std::vector<SparseEntries> solved = elimination.solved();
  std::vector<int> place(unknowns);  // in its cluster
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [rows, inside] : members) {
    const int rank = static_cast<int>(rows.size()), count = static_cast<int>(inside.size());
    if (count <= kOrthonormalCluster) {
      for (int k = 0; k < count; ++k) place[inside[k]] = k;
      Eigen::MatrixXd transposed = Eigen::MatrixXd::Zero(count, rank);
      for (int i = 0; i < rank; ++i) {
        for (decltype(matrix_)::InnerIterator it(matrix_, rows[i]); it; ++it)
          transposed(place[it.col()], i) = it.value();
      }
      const Eigen::MatrixXd block = complement(std::move(transposed));
      for (int k = rank; k < count; ++k) {
        for (int i = 0; i < count; ++i) {
          if (block(i, k - rank) != 0) entries.emplace_back(inside[i], column[inside[k]], block(i, k - rank));
        }
      }
      continue;
    }
    orthonormal_ = false;
    for (int k = rank; k < count; ++k) {
      entries.emplace_back(inside[k], column[inside[k]], 1);
      free_unknown_[column[inside[k]]] = inside[k];
    }
    for (const int row : rows) {
      for (const auto& [unknown, value] : solved[row])
        entries.emplace_back(elimination.pivot(row), column[unknown], value);
    }
  }
  basis_.resize(unknowns, static_cast<Eigen::Index>(free_unknown_.size()));
  basis_.setFromTriplets(entries.begin(), entries.end());
}

/// q + A^T (A A^T)^-1 (b - A q), repeated until rounding is all that is left.
Eigen::VectorXd AffineSubspace::nearest(const Eigen::VectorXd& q) const {
  Eigen::VectorXd result = q;
  if (right_.size() == 0) return result;
  Eigen::VectorXd residual = right_ - matrix_ * result;
  for (int pass = 0; pass < kRefinements; ++pass) {
    const Eigen::VectorXd next = result + matrix_.transpose() * products_.solve(residual);
    const Eigen::VectorXd left = right_ - matrix_ * next;
    if (pass > 0 && left.cwiseAbs().maxCoeff() >= residual.cwiseAbs().maxCoeff()) break;
    result = next;
    residual = left;
  }
  return result;
}

Eigen::VectorXd AffineSubspace::coordinates(const Eigen::VectorXd& q) const {
  const Eigen::VectorXd difference = nearest(q) - origin_;
  Eigen::VectorXd y = basis_.transpose() * difference;
  for (Eigen::Index k = 0; k < y.size(); ++k) {
    if (free_unknown_[k] >= 0) y[k] = difference[free_unknown_[k]];
  }
  return y;
}

/// (A A^T)^-1 A g, in the rows as they were given.
Eigen::VectorXd AffineSubspace::multipliers(const Eigen::VectorXd& g) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(rows_.count());
  if (right_.size() == 0) return result;
  Eigen::VectorXd lambda = Eigen::VectorXd::Zero(right_.size());
  for (int pass = 0; pass < kRefinements; ++pass) {
    const Eigen::VectorXd rest = g - matrix_.transpose() * lambda;
    const Eigen::VectorXd step = products_.solve(Eigen::VectorXd(matrix_ * rest));
    lambda += step;
    if (step.norm() <= 1e-15 * lambda.norm()) break;
  }
  for (Eigen::Index row = 0; row < lambda.size(); ++row) {
    result[independent_[row]] = lambda[row] / lengths_[independent_[row]];
  }
  return result;
}

Eigen::MatrixXd AffineSubspace::kept(const Eigen::MatrixXd& directions) const {
  // Orthonormal directions, without those that depend on others.
  const SymmetricEigen products = symmetric_eigen(directions.transpose() * directions);
  const Eigen::Index count = directions.cols();
  Eigen::Index first = 0;
  while (first < count && products.values[first] <= 1e-12 * products.values[count - 1]) ++first;
  Eigen::MatrixXd d = directions * products.vectors.rightCols(count - first);
  for (Eigen::Index k = 0; k < d.cols(); ++k) d.col(k) /= std::sqrt(products.values[first + k]);
  if (right_.size() == 0 || d.cols() == 0) return d;

  const Eigen::MatrixXd changes = matrix_ * d;
  double most = 0;  // the squared length of d where a row, of length 1, is not 0
  for (Eigen::Index row = 0; row < matrix_.rows(); ++row) {
    double square = 0;
    for (decltype(matrix_)::InnerIterator it(matrix_, row); it; ++it) square += d.row(it.col()).squaredNorm();
    most = std::max(most, square);
  }
  const SymmetricEigen squares = symmetric_eigen(changes.transpose() * changes);
  Eigen::Index dimension = 0;
  while (dimension < d.cols() && squares.values[dimension] <= kKeptDirection * kKeptDirection * most) ++dimension;
  return d * squares.vectors.leftCols(dimension);
}

}  // namespace umbilic
