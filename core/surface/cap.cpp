// SPDX-License-Identifier: MIT
/// \file
/// Blends and fits in a sector of a cap.
#include "surface/cap.h"

#include <Eigen/QR>
#include <cassert>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "surface/blend.h"
#include "surface/quadrature.h"

namespace umbilic {
namespace {

/// Enough that the fit does not change in its tenth digit.
constexpr int kFitPoints = 12;
constexpr int kFitGrading = 2;

int degree(CapShape shape) { return shape == CapShape::kTwoRing ? 4 : 3; }

/// Samples where the blend of `shape` varies, in sector coordinates.
std::vector<Sample> fit_samples(CapShape shape) {
  if (shape == CapShape::kOneRing) return graded_rule(kFitPoints, kFitGrading);
  std::vector<Sample> samples;
  for (const auto& [i, j] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
    for (const Sample& s : tensor_rule(kFitPoints)) samples.push_back({s.u + i, s.v + j, s.weight});
  }
  return samples;
}

}  // namespace

CapSector::CapSector(int valence, CapShape shape) : net_(valence), shape_(shape) {
  if (coefficient_count(shape) == 0) return;
  characteristic_ = net_.characteristic_net();
  build_fit();
}

Derivatives CapSector::blend(double u, double v) const {
  switch (shape_) {
    case CapShape::kBare: return Derivatives::Zero();
    case CapShape::kFlat: return tensor_blend(paper_blend, u, v, 1);
    case CapShape::kOneRing: return tensor_blend(smoothstep_blend, u, v, 1);
    case CapShape::kTwoRing: return tensor_blend(smoothstep_blend, u, v, 2);
  }
  return Derivatives::Zero();
}

/// Monomials x^(k-l) y^l of the characteristic map, by rising degree k, where the limit surface has this basis.
DerivativeRows CapSector::polynomials(const DerivativeRows& surface) const {
  const Eigen::Matrix<double, kDerivativeCount, 2> xy = surface * characteristic_;
  const Derivatives x = xy.col(0), y = xy.col(1);
  DerivativeRows rows(kDerivativeCount, coefficient_count(shape_));
  rows.col(0) = Derivatives::Unit(0);
  int column = 1;
  for (int k = 1; k <= degree(shape_); ++k) {
    const int previous = column - k;
    for (int l = 0; l < k; ++l) rows.col(column++) = product(x, rows.col(previous + l));
    rows.col(column++) = product(y, rows.col(previous + k - 1));
  }
  return rows;
}

DerivativeRows CapSector::basis(double u, double v) const {
  const DerivativeRows surface = net_.basis(u, v);
  const int coefficients = coefficient_count(shape_);
  if (coefficients == 0) return surface;
  const Derivatives b = blend(u, v);
  DerivativeRows rows(kDerivativeCount, net_.size() + coefficients);
  rows << product(Derivatives::Unit(0) - b, surface), product(b, polynomials(surface));
  return rows;
}

DerivativeRows CapSector::flattening(double u, double v) const {
  DerivativeRows offset = net_.basis(u, v);
  offset.row(0) -= net_.limit_position();
  return product(blend(u, v), offset);
}

void CapSector::build_fit() {
  const std::vector<Sample> samples = fit_samples(shape_);
  const int count = static_cast<int>(samples.size()), valence = net_.valence();
  const double angle = 2 * std::acos(-1.0) / valence;
  Eigen::MatrixXd surface = Eigen::MatrixXd::Zero(count * valence, net_.size());
  Eigen::MatrixXd monomials(count * valence, coefficient_count(shape_));
  for (int s = 0; s < count; ++s) {
    const auto [u, v, area] = samples[s];
    const Derivatives b = blend(u, v);
    const double weight = std::sqrt(area * (b[1] * b[1] + b[2] * b[2]));
    const Eigen::RowVectorXd here = net_.basis(u, v).row(0);
    const Eigen::RowVector2d xy = here * characteristic_;
    for (int sector = 0; sector < valence; ++sector) {
      const int row = sector * count + s;
      surface(row, 0) = weight * here[0];
      for (int i = 1; i < net_.size(); ++i) {
        surface(row, 1 + (i - 1 + 12 * sector) % (net_.size() - 1)) = weight * here[i];
      }
      const double c = std::cos(sector * angle), d = std::sin(sector * angle);
      const double x = c * xy[0] - d * xy[1], y = d * xy[0] + c * xy[1];
      int column = 0;
      for (int k = 0; k <= degree(shape_); ++k) {
        for (int l = 0; l <= k; ++l) monomials(row, column++) = weight * std::pow(x, k - l) * std::pow(y, l);
      }
    }
  }
  fit_ = monomials.householderQr().solve(surface);
}

const CapSector& cap_sector(int valence, CapShape shape) {
  static std::mutex mutex;
  static std::map<std::pair<int, CapShape>, CapSector> sectors;  // never moves what it holds
  const std::lock_guard lock(mutex);
  const std::pair key{valence, shape};
  const auto found = sectors.find(key);
  return found != sectors.end() ? found->second : sectors.try_emplace(key, valence, shape).first->second;
}

}  // namespace umbilic
