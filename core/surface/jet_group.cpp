// SPDX-License-Identifier: MIT
/// \file
/// Tensor rules on regular faces, tables on the others.
#include "surface/jet_group.h"

namespace umbilic {

JetGroup::JetGroup(const PatchSet& patches, const QuadratureRule& rule) : set_(patches) {
  if (set_.kind.regular()) {
    regular_ = std::make_unique<RegularKernel>(rule.regular_points);
  } else {
    table_ = kernel_table(set_.kind, rule);
  }
}

}  // namespace umbilic
