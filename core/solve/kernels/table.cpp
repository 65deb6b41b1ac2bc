// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels for one instruction set.
#include "solve/kernels/dense_elimination.h"

namespace umbilic::UMBILIC_KERNELS {

extern const SolveKernels kSolveKernels{eliminate_panel, eliminate_block, subtract_block, subtract_product,
                                        scratch_size};

}  // namespace umbilic::UMBILIC_KERNELS
