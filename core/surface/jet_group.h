// SPDX-License-Identifier: MIT
/// \file
/// What all patches of one kind share in a JetEvaluator: the samples, and the basis at them as the kernels want it.
#pragma once

#include <memory>

#include "base/aligned_doubles.h"
#include "surface/layout.h"
#include "surface/regular_kernel.h"

namespace umbilic {

class JetGroup {
 public:
  /// `patches` outlive the group.
  JetGroup(const PatchSet& patches, const QuadratureRule& rule);

  const PatchSet& set() const { return set_; }
  bool flat() const { return set_.kind.shape == CapShape::kFlat; }

  int samples() const { return samples_; }
  const double* weights() const { return weights_.data(); }  ///< of the samples
  /// Samples with weight > 0, of all patches.
  long sample_count() const { return (weights_.array() > 0).count() * set_.count(); }
  std::size_t bytes() const;

  /// For regular faces.
  const RegularKernel& regular() const { return *regular_; }
  /// For the others: rows (derivative, sample), derivatives from X_u; for `kFlat` also the flattening's.
  DenseTable basis() const { return {basis_.data(), stride_, set_.columns}; }
  DenseTable flattening() const { return {flattening_.data(), stride_, set_.columns}; }

 private:
  AlignedDoubles aligned(const Eigen::MatrixXd& table) const;

  const PatchSet& set_;
  std::unique_ptr<RegularKernel> regular_;
  AlignedDoubles basis_, flattening_;
  int stride_ = 0, samples_ = 0;
  Eigen::VectorXd weights_;
};

}  // namespace umbilic
