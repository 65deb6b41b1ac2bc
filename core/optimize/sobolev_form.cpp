// SPDX-License-Identifier: MIT
/// \file
/// Products of covariant derivatives at the samples of a coarse rule.
#include "optimize/sobolev_form.h"

#include <cmath>

#include "optimize/covariant.h"

namespace umbilic {
namespace {

/// A metric needs no exact integrals, only that no direction is missed.
constexpr QuadratureRule kRule{3, 3, 2};

double second_order_weight(const Weights& w) { return w[kBending] + w[kWillmore] / 4; }

double third_order_weight(const Weights& w) {
  return w[kMvs] + w[kMvsCross] + w[kMehlumTarrou] / 2 + w[kSecondFormVariation];
}

/// The derivatives of order 1 to 3 at sample s of something with the table's rows.
template <class Rows>
Eigen::Matrix<double, kThirdOrderCount, Rows::ColsAtCompileTime> at_sample(const Rows& all, int samples, int s) {
  Eigen::Matrix<double, kThirdOrderCount, Rows::ColsAtCompileTime> rows(kThirdOrderCount, all.cols());
  for (int d = 0; d < kThirdOrderCount; ++d) rows.row(d) = all.row((d + 1) * samples + s);
  return rows;
}

}  // namespace

SobolevForm::SobolevForm(const PatchLayout& layout, const Weights& weights)
    : layout_(layout), second_(second_order_weight(weights)), third_(third_order_weight(weights)) {
  for (const PatchSet& set : layout.sets()) {
    kinds_.push_back({shared_basis_table(set.kind, kRule), {}});
    Kind& kind = kinds_.back();
    if (set.kind.shape == CapShape::kFlat) kind.normal_part = kind.table->basis - kind.table->flattening;
  }
}

void SobolevForm::move_to(const Points& control, double area) {
  points_ = layout_.extend(control);
  frames_ = flat_frames(layout_, points_);
  area_ = area;
}

/// The surface's derivatives of order 0 to 3 at all samples of a patch, in the order of the table's rows.
Eigen::Matrix<double, Eigen::Dynamic, 3> SobolevForm::jets(int set, int patch) const {
  const PatchSet& patches = layout_.sets()[set];
  const Kind& kind = kinds_[set];
  Eigen::Matrix<double, Eigen::Dynamic, 3> local(patches.columns, 3);
  for (int i = 0; i < patches.columns; ++i) local.row(i) = points_.row(patches.points[patches.columns * patch + i]);
  Eigen::Matrix<double, Eigen::Dynamic, 3> result = kind.table->basis * local;
  if (patches.kind.shape == CapShape::kFlat) {
    const Vector3& n = frames_[patches.caps[patch]].normal;
    result -= (kind.table->flattening * (local * n)) * n.transpose();
  }
  return result;
}

Eigen::MatrixXd SobolevForm::patch(int set, int patch) const {
  const Kind& kind = kinds_[set];
  const BasisTable& table = *kind.table;
  const Eigen::MatrixXd& functions = kind.functions();
  const double length = 10 / std::sqrt(area_);
  const double mass = 0.01 * (2 * second_ * std::pow(length, 4) + 2 * third_ * area_ * std::pow(length, 6));
  const auto x = jets(set, patch);
  const int second_rows = second_ > 0 ? 3 : 0, third_rows = third_ > 0 ? 6 : 0,
            per_sample = 1 + second_rows + third_rows;
  Eigen::MatrixXd rows(per_sample * table.samples, table.columns);
  for (int s = 0; s < table.samples; ++s) {
    const auto basis = at_sample(functions, table.samples, s);
    const CovariantDerivatives covariant(at_sample(x, table.samples, s), third_ > 0);
    const double measure = table.weights[s] * covariant.area;
    auto here = rows.middleRows(per_sample * s, per_sample);
    here.row(0) = std::sqrt(measure * mass) * functions.row(s);
    if (second_ > 0) {
      const SecondCovariant weighted = std::sqrt(2 * second_ * measure) * covariant.second;
      here.middleRows<3>(1) = weighted.lazyProduct(basis);
    }
    if (third_ > 0) {
      const ThirdCovariant weighted = std::sqrt(2 * third_ * area_ * measure) * covariant.third;
      here.bottomRows<6>() = weighted.lazyProduct(basis);
    }
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(table.columns, table.columns);
  result.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  return result;
}

}  // namespace umbilic
