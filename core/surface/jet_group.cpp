// SPDX-License-Identifier: MIT
/// \file
/// Tensor rules on regular faces, tables on the others.
#include "surface/jet_group.h"

#include "base/lanes.h"

namespace umbilic {

JetGroup::JetGroup(const PatchSet& patches, const QuadratureRule& rule) : set_(patches) {
  if (set_.kind.regular()) {
    regular_ = std::make_unique<RegularKernel>(rule.regular_points);
    samples_ = regular_->samples();
    weights_ = regular_->weights();
    return;
  }
  std::vector<Sample> points =
      set_.kind.at_extraordinary() ? graded_rule(rule.cap_points, rule.grading) : tensor_rule(rule.cap_points);
  pad_samples(points, kSampleMultiple);
  BasisTable table = basis_table(set_.kind, points, 1, kDerivativeCount);
  samples_ = table.samples;
  weights_ = std::move(table.weights);
  constexpr int kLine = kCacheLine / sizeof(double);
  stride_ = static_cast<int>((table.basis.rows() + kLine - 1) / kLine * kLine);
  basis_ = aligned(table.basis);
  if (flat()) flattening_ = aligned(table.flattening);
}

AlignedDoubles JetGroup::aligned(const Eigen::MatrixXd& table) const {
  AlignedDoubles copy(static_cast<std::size_t>(stride_) * table.cols());
  Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(copy.data(), table.rows(), table.cols(),
                                                       Eigen::OuterStride<>(stride_)) = table;
  return copy;
}

std::size_t JetGroup::bytes() const {
  const std::size_t own = basis_.size() + flattening_.size() + weights_.size();
  return sizeof(double) * own + (regular_ ? regular_->bytes() : 0);
}

}  // namespace umbilic
