// SPDX-License-Identifier: MIT
/// \file
/// What all patches of one kind share: the samples, and the basis at them.
#pragma once

#include <memory>

#include "surface/basis_table.h"
#include "surface/regular_kernel.h"

namespace umbilic {

class PatchBasis {
 public:
  /// For a rule, used only for derivatives of order 1 and up: regular faces get a tensor kernel instead of a table.
  PatchBasis(const PatchKind& kind, const QuadratureRule& rule);
  explicit PatchBasis(std::shared_ptr<const BasisTable> table) : table_(std::move(table)) {}

  int samples() const { return regular_ ? regular_->samples() : table_->samples; }
  const Eigen::VectorXd& weights() const { return regular_ ? regular_->weights() : table_->weights; }
  std::size_t bytes() const { return regular_ ? regular_->bytes() : table_->bytes(); }

  /// Null if there is a table.
  const RegularKernel* regular() const { return regular_.get(); }
  const BasisTable& table() const { return *table_; }

 private:
  std::unique_ptr<RegularKernel> regular_;
  std::shared_ptr<const BasisTable> table_;
};

}  // namespace umbilic
