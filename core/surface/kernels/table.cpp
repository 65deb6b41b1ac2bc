// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels for one instruction set.
#include "surface/kernels/dense_product.h"
#include "surface/kernels/regular_contraction.h"

namespace umbilic::UMBILIC_KERNELS {

extern const SurfaceKernels kSurfaceKernels{regular_jets, pull_back_regular_jets, dense_product,
                                            dense_transposed_product};

}  // namespace umbilic::UMBILIC_KERNELS
