// SPDX-License-Identifier: MIT
/// \file
/// Chooses between the tensor kernel and the table.
#include "surface/patch_basis.h"

namespace umbilic {

PatchBasis::PatchBasis(const PatchKind& kind, const QuadratureRule& rule) {
  if (kind.regular()) {
    regular_ = std::make_unique<RegularKernel>(rule.regular_points);
  } else {
    table_ = shared_basis_table(kind, rule, 1);
  }
}

}  // namespace umbilic
