// SPDX-License-Identifier: MIT
/// \file
/// What all patches of one kind share in a JetEvaluator: the samples, and the basis at them as the kernels want it.
#pragma once

#include <memory>

#include "surface/kernel_table.h"
#include "surface/layout.h"
#include "surface/regular_kernel.h"

namespace umbilic {

class JetGroup {
 public:
  /// `patches` outlive the group.
  JetGroup(const PatchSet& patches, const QuadratureRule& rule);

  const PatchSet& set() const { return set_; }
  bool flat() const { return set_.kind.shape == CapShape::kFlat; }

  int samples() const { return regular_ ? regular_->samples() : table_->samples; }
  const double* weights() const { return all_weights().data(); }  ///< of the samples
  /// Samples with weight > 0, of all patches.
  long sample_count() const { return (all_weights().array() > 0).count() * set_.count(); }
  std::size_t bytes() const { return regular_ ? regular_->bytes() : table_->bytes(); }

  /// For regular faces.
  const RegularKernel& regular() const { return *regular_; }
  /// For the others: rows (derivative, sample), derivatives from X_u; for `kFlat` also the flattening's.
  DenseTable basis() const { return {table_->basis.data(), table_->stride, set_.columns}; }
  DenseTable flattening() const { return {table_->flattening.data(), table_->stride, set_.columns}; }

 private:
  const Eigen::VectorXd& all_weights() const { return regular_ ? regular_->weights() : table_->weights; }

  const PatchSet& set_;
  std::unique_ptr<RegularKernel> regular_;
  std::shared_ptr<const KernelTable> table_;
};

}  // namespace umbilic
