// SPDX-License-Identifier: MIT
/// \file
/// A kind's basis at the samples of a rule as the kernels want it, shared by everything in the process that needs it.
#pragma once

#include <memory>

#include "base/aligned_doubles.h"
#include "surface/basis_table.h"
#include "surface/surface_kernels.h"

namespace umbilic {

/// Surplus columns are zero.
inline constexpr int kColumnMultiple = 4;

struct KernelTable {
  int samples = 0;            ///< a multiple of kSampleMultiple: the last one is repeated with weight 0
  int columns = 0;            ///< a multiple of kColumnMultiple
  int stride = 0;             ///< from column to column, whole cache lines
  Eigen::VectorXd weights;    ///< of the samples
  AlignedDoubles basis;       ///< derivatives of order 1 to 3: row (d - 1) samples + s
  AlignedDoubles flattening;  ///< the same for `kFlat`; else empty

  int rows() const { return kThirdOrderCount * samples; }
  std::size_t bytes() const { return sizeof(double) * (basis.size() + flattening.size() + weights.size()); }
};

std::shared_ptr<const KernelTable> kernel_table(const PatchKind& kind, const QuadratureRule& rule);

}  // namespace umbilic
