// SPDX-License-Identifier: MIT
/// \file
/// A small eigenvalue problem, and some evaluations along a line.
#include "driver/descent.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/symmetric_eigen.h"
#include "driver/gauss_bonnet.h"

namespace umbilic {
namespace {

/// Combinations whose product with themselves is below this, relative to the largest, are rounding errors.
constexpr double kIndependent = 1e-8;

/// The longest distance that is tried, as the largest displacement of a control point relative to the surface's
/// extent, and how often it is halved. Third-order energies are not smooth at umbilic points, and may fall only over
/// very short distances: along the direction of the octahedron's frame, mvs_cross at level 2, up to 5e-5, by 2e-8 of
/// the energy. Nobody would call that a lower surface, and a search for symmetries takes it for the same one.
constexpr double kLongest = 0.1;
constexpr int kHalvings = 8;

Eigen::MatrixXd symmetric(const Eigen::MatrixXd& matrix) { return (matrix + matrix.transpose()) / 2; }

}  // namespace

std::optional<Eigen::VectorXd> steepest(const Eigen::MatrixXd& candidates, const Eigen::MatrixXd& second,
                                        const Eigen::MatrixXd& product) {
  if (candidates.cols() == 0) return std::nullopt;
  const SymmetricEigen lengths = symmetric_eigen(symmetric(candidates.transpose() * product));
  const double largest = lengths.values.maxCoeff();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < lengths.values.size(); ++i) {
    if (lengths.values[i] > kIndependent * largest) kept.push_back(i);
  }
  if (kept.empty()) return std::nullopt;
  const Eigen::VectorXd scale = lengths.values(kept).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd basis = lengths.vectors(Eigen::all, kept) * scale.asDiagonal();
  const SymmetricEigen eigen = symmetric_eigen(symmetric(basis.transpose() * candidates.transpose() * second * basis));
  if (!(eigen.values[0] < 0)) return std::nullopt;
  return candidates * basis * eigen.vectors.col(0);
}

std::optional<Points> moved_down(const Surface& surface, const Points& direction) {
  const Points& start = surface.start();
  const double extent = (start.colwise().maxCoeff() - start.colwise().minCoeff()).maxCoeff();
  const double length = direction.rowwise().norm().maxCoeff();
  const auto energy = [&](const Points& control) {
    const EnergyValue value = surface.energy().evaluate(control, nullptr);
    const double turning = surface.mesh().is_open() ? surface.turning(control) : 0;
    const double defect = std::abs(value.gaussian + turning - surface.expected_gaussian());
    const double sum = value.energy + (surface.closeness() ? surface.closeness()->evaluate(control, nullptr) : 0);
    return defect <= kLargestDefect ? sum : std::numeric_limits<double>::infinity();
  };
  double least = energy(start);
  std::optional<Points> best;
  double step = kLongest * extent / length;
  for (int i = 0; i <= kHalvings; ++i, step /= 2) {
    for (const double signed_step : {step, -step}) {
      Points moved = start + signed_step * direction;
      const double there = energy(moved);
      if (!(there < least)) continue;
      least = there;
      best = std::move(moved);
    }
  }
  return best;
}

}  // namespace umbilic
