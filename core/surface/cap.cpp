// SPDX-License-Identifier: MIT
/// \file
/// Blends and least-squares fits in a sector of a cap.
#include "surface/cap.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <tuple>

#include "surface/blend.h"
#include "surface/quadrature.h"

namespace umbilic {
namespace {

/// Enough points that more would change the fit by less than 1e-10.
constexpr int kFitPoints = 12;
constexpr int kFitGrading = 2;

/// The samples on a face at which Q is fitted to S; none if the face is in no fitted ring.
std::vector<Sample> fit_samples(CapShape shape, int valence, int cell) {
  if (shape == CapShape::kOneRing) return graded_rule(kFitPoints, kFitGrading);
  const int ring = ring_of(shape, cell);
  const auto [first, last] = fit_rings(shape, valence);
  const bool fitted = ring >= first && ring <= last;
  return fitted ? tensor_rule(kFitPoints) : std::vector<Sample>();
}

/// Index of x^(k-l) y^l among the monomials, sorted by degree k.
int monomial(int k, int l) { return k * (k + 1) / 2 + l; }

}  // namespace

CapSector::CapSector(int valence, CapShape shape, int fitted)
    : net_(valence, std::max(2, rings(shape))), shape_(shape) {
  if (coefficient_count(shape) == 0) return;
  const Eigen::Matrix<double, Eigen::Dynamic, 2> characteristic = net_.characteristic_net();
  characteristic_.resize(cell_count(shape));
  for (int cell = 0; cell < cell_count(shape); ++cell) {
    const std::vector<int>& support = net_.support(cell);
    characteristic_[cell].resize(static_cast<Eigen::Index>(support.size()), 2);
    for (std::size_t i = 0; i < support.size(); ++i) {
      characteristic_[cell].row(static_cast<Eigen::Index>(i)) = characteristic.row(support[i]);
    }
  }
  build_turns();
  build_fit(fitted);
}

Derivatives CapSector::blend(int cell, double u, double v) const {
  switch (shape_) {
    case CapShape::kBare: return Derivatives::Zero();
    case CapShape::kFlat: return tensor_blend(paper_blend, u, v, 1);
    case CapShape::kOneRing:
    case CapShape::kTwoRing:
    case CapShape::kFourRing:
    case CapShape::kEightRing:
    case CapShape::kSixteenRing: {
      const int i = cell % rings(shape_), j = cell / rings(shape_);
      return tensor_blend(smoothstep_blend, i + u, j + v, rings(shape_));
    }
  }
  return Derivatives::Zero();
}

/// Derivatives of the monomials x^(k-l) y^l of the characteristic map, sorted by degree k.
DerivativeRows CapSector::polynomials(const Derivatives& x, const Derivatives& y) const {
  DerivativeRows rows(kDerivativeCount, coefficient_count(shape_));
  rows.col(0) = Derivatives::Unit(0);
  rows.col(1) = x;
  rows.col(2) = y;
  for (int k = 2; k <= degree(shape_); ++k) {
    for (int l = 0; l < k; ++l) rows.col(monomial(k, l)) = product(x, rows.col(monomial(k - 1, l)));
    rows.col(monomial(k, k)) = product(y, rows.col(monomial(k - 1, k - 1)));
  }
  return rows;
}

DerivativeRows CapSector::basis(int cell, double u, double v) const {
  const DerivativeRows surface = net_.face_basis(cell, u, v);
  const int coefficients = coefficient_count(shape_);
  if (coefficients == 0) return surface;
  const Derivatives b = blend(cell, u, v);
  const Eigen::Matrix<double, kDerivativeCount, 2> xy = surface.lazyProduct(characteristic_[cell]);
  DerivativeRows rows(kDerivativeCount, surface.cols() + coefficients);
  rows << product(Derivatives::Unit(0) - b, surface), product(b, polynomials(xy.col(0), xy.col(1)));
  return rows;
}

DerivativeRows CapSector::flattening(double u, double v) const {
  DerivativeRows offset = net_.face_basis(0, u, v);
  const Eigen::RowVectorXd position = net_.limit_position();
  for (Eigen::Index i = 0; i < offset.cols(); ++i) offset(0, i) -= position[net_.support(0)[i]];
  return product(blend(0, u, v), offset);
}

/// A point with complex coordinate z in a sector has coordinate e^(i angle) z in sector 0. The monomial x^(k-l) y^l of
/// sector 0 is therefore (c x - s y)^(k-l) (s x + c y)^l in the sector's coordinates, which is expanded one factor at a
/// time.
void CapSector::build_turns() {
  const double angle = 2 * std::numbers::pi / net_.valence();
  for (int sector = 0; sector < net_.valence(); ++sector) {
    const double c = std::cos(sector * angle), s = std::sin(sector * angle);
    Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(coefficient_count(shape_), coefficient_count(shape_));
    turn(0, 0) = 1;
    for (int k = 1; k <= degree(shape_); ++k) {
      for (int l = 0; l <= k; ++l) {
        // Multiplies a monomial of degree k - 1 by the turned x, or by the turned y if it has no x.
        const double along_x = l < k ? c : s, along_y = l < k ? -s : c;
        const int before = monomial(k - 1, l < k ? l : k - 1);
        for (int m = 0; m < k; ++m) {
          turn(monomial(k, m), monomial(k, l)) += along_x * turn(monomial(k - 1, m), before);
          turn(monomial(k, m + 1), monomial(k, l)) += along_y * turn(monomial(k - 1, m), before);
        }
      }
    }
    turns_.push_back(std::move(turn));
  }
}

namespace {

/// The normal equations of the fit over all sectors, from the contribution of sector 0.
struct NormalEquations {
  Eigen::MatrixXd gram, moments;

  /// Replaces the contribution of sector 0 by the sum over the first `fitted` sectors, each of which is sector 0's
  /// turned.
  void turn(const std::vector<Eigen::MatrixXd>& turns, int fitted) {
    const NormalEquations here = *this;
    const Eigen::Index ring = moments.cols() - 1, per_sector = ring / static_cast<Eigen::Index>(turns.size());
    gram.setZero();
    moments.setZero();
    for (int sector = 0; sector < fitted; ++sector) {
      gram += turns[sector].transpose() * here.gram * turns[sector];
      const Eigen::MatrixXd turned = turns[sector].transpose() * here.moments;
      const Eigen::Index shift = per_sector * sector;
      moments.col(0) += turned.col(0);
      moments.rightCols(ring - shift) += turned.middleCols(1, ring - shift);
      moments.middleCols(1, shift) += turned.rightCols(shift);
    }
  }
};

}  // namespace

/// Solves the normal equations twice. The Cholesky factor of the first solve makes the polynomials orthonormal for the
/// second, which makes the result as accurate as that of a QR factorization.
void CapSector::build_fit(int fitted) {
  const int count = coefficient_count(shape_), cells = cell_count(shape_);
  std::vector<Eigen::MatrixXd> surfaces(cells), polynomials(cells);
  for (int cell = 0; cell < cells; ++cell) {
    const std::vector<Sample> samples = fit_samples(shape_, net_.valence(), cell);
    Eigen::MatrixXd &surface = surfaces[cell], &monomials = polynomials[cell];
    surface.resize(samples.size(), net_.support(cell).size());
    monomials.resize(count, samples.size());
    for (std::size_t s = 0; s < samples.size(); ++s) {
      const auto [u, v, area] = samples[s];
      const Derivatives b = blend(cell, u, v);
      const double weight = std::sqrt(area * (b[1] * b[1] + b[2] * b[2]));
      const Eigen::RowVectorXd here = net_.face_basis(cell, u, v).row(0);
      const Eigen::RowVector2d xy = here.lazyProduct(characteristic_[cell]);
      const auto column = static_cast<Eigen::Index>(s);
      surface.row(column) = weight * here;
      monomials(0, column) = weight;
      for (int k = 1; k <= degree(shape_); ++k) {
        for (int l = 0; l < k; ++l) monomials(monomial(k, l), column) = xy[0] * monomials(monomial(k - 1, l), column);
        monomials(monomial(k, k), column) = xy[1] * monomials(monomial(k - 1, k - 1), column);
      }
    }
  }
  const auto equations = [&](const std::vector<Eigen::MatrixXd>& turns) {
    NormalEquations sums{Eigen::MatrixXd::Zero(count, count), Eigen::MatrixXd::Zero(count, net_.size())};
    for (int cell = 0; cell < cells; ++cell) {
      sums.gram += polynomials[cell] * polynomials[cell].transpose();
      const Eigen::MatrixXd products = polynomials[cell] * surfaces[cell];
      for (Eigen::Index i = 0; i < products.cols(); ++i) sums.moments.col(net_.support(cell)[i]) += products.col(i);
    }
    sums.turn(turns, fitted);
    return sums;
  };
  const Eigen::LLT<Eigen::MatrixXd> first(equations(turns_).gram);
  const auto lower = first.matrixL();
  std::vector<Eigen::MatrixXd> turns;
  for (const Eigen::MatrixXd& turn : turns_) {
    turns.push_back(lower.solve(Eigen::MatrixXd((lower.transpose() * turn).transpose())).transpose());
  }
  for (Eigen::MatrixXd& values : polynomials) lower.solveInPlace(values);
  const NormalEquations second = equations(turns);
  fit_ = lower.transpose().solve(Eigen::MatrixXd(second.gram.llt().solve(second.moments)));
  for (int i = 0; i < fit_.cols(); ++i) {
    if (!fit_.col(i).isZero(0)) fit_support_.push_back(i);
  }
}

const CapSector& cap_sector(int valence, CapShape shape, int fitted) {
  static std::mutex mutex;
  static std::map<std::tuple<int, CapShape, int>, CapSector> sectors;  // a map never moves its elements
  if (coefficient_count(shape) == 0) fitted = valence;                 // nothing is fitted
  const std::lock_guard lock(mutex);
  const std::tuple key{valence, shape, fitted};
  const auto found = sectors.find(key);
  return found != sectors.end() ? found->second : sectors.try_emplace(key, valence, shape, fitted).first->second;
}

}  // namespace umbilic
