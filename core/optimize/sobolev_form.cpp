// SPDX-License-Identifier: MIT
/// \file
/// Products of covariant derivatives at the samples of a low-order rule.
#include "optimize/sobolev_form.h"

#include <cmath>
#include <numbers>

#include "optimize/covariant.h"
#include "optimize/metric_rules.h"
#include "solve/solve_kernels.h"

namespace umbilic {
namespace {

double second_order_weight(const Weights& w) { return w[kBending] + w[kWillmore] / 4; }

/// About a sphere curvedness_variation is H^2 area = 4 pi times mean_curvature_variation.
double third_order_weight(const Weights& w) {
  constexpr double kCurvednessOfMean = 4 * std::numbers::pi;
  return w[kMvs] + w[kMvsCross] + w[kMehlumTarrou] / 2 + w[kSecondFormVariation] + w[kMeanCurvatureVariation] +
         kCurvednessOfMean * w[kCurvednessVariation];
}

/// The derivatives of order 1 to 3 at sample s, from rows d * samples + s.
template <class Rows>
Eigen::Matrix<double, kThirdOrderCount, Rows::ColsAtCompileTime> at_sample(const Rows& all, int samples, int s) {
  Eigen::Matrix<double, kThirdOrderCount, Rows::ColsAtCompileTime> rows(kThirdOrderCount, all.cols());
  for (int d = 0; d < kThirdOrderCount; ++d) rows.row(d) = all.row(d * samples + s);
  return rows;
}

}  // namespace

SobolevForm::SobolevForm(const PatchLayout& layout, const Weights& weights)
    : patches_(layout, [](const PatchKind& kind) { return PatchBasis(shared_basis_table(kind, kSobolevRule, 0)); }),
      second_(second_order_weight(weights)),
      third_(third_order_weight(weights)) {}

void SobolevForm::move_to(const Points& control, double area) {
  patches_.move_to(control);
  area_ = area;
}

Eigen::MatrixXd SobolevForm::patch(int set, int patch, SobolevMemory& memory) const {
  const BasisTable& table = patches_.basis(set).table();
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>> jets(
      patches_.jets({set, patch, 1}, kThirdOrderCount, memory.patches),
      static_cast<Eigen::Index>(kThirdOrderCount) * table.samples, 3);
  const BasisTable::View values = table.view(0, table.along_normal()),
                         derivatives = table.view(1, table.along_normal());
  const double length = kMassWaves / std::sqrt(area_);
  const double mass = kMassShare * (2 * second_ * std::pow(length, 4) + 2 * third_ * area_ * std::pow(length, 6));
  const int second_rows = second_ > 0 ? 3 : 0, third_rows = third_ > 0 ? 6 : 0,
            per_sample = 1 + second_rows + third_rows;
  // What is summed over the rows r is w r^T r.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(per_sample * table.distinct,
                                                                              table.columns);
  Eigen::VectorXd weights(rows.rows());
  for (int s = 0; s < table.distinct; ++s) {
    const auto basis = at_sample(derivatives, table.samples, s);
    const CovariantDerivatives covariant(at_sample(jets, table.samples, s), third_ > 0);
    const double measure = table.weights[s] * covariant.area;
    auto here = rows.middleRows(per_sample * s, per_sample);
    auto weight = weights.segment(per_sample * s, per_sample);
    here.row(0) = values.row(s);
    weight[0] = measure * mass;
    if (second_ > 0) {
      here.middleRows<3>(1) = covariant.second.lazyProduct(basis);
      weight.segment<3>(1).setConstant(2 * second_ * measure);
    }
    if (third_ > 0) {
      here.bottomRows<6>() = covariant.third.lazyProduct(basis);
      weight.tail<6>().setConstant(2 * third_ * area_ * measure);
    }
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(table.columns, table.columns);
  weights = -weights;
  const SolveKernels& kernels = solve_kernels();
  double* scratch = reserve(memory.scratch, kernels.scratch_size(table.columns));
  const DenseFactor transposed{rows.data(), table.columns, table.columns, static_cast<int>(rows.rows())};
  kernels.subtract_product(transposed, weights.data(), 0, table.columns, result.data(), scratch);
  return result;
}

}  // namespace umbilic
