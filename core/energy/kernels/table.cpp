// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels for one instruction set.
#include "energy/kernels/integrals.h"
#include "energy/kernels/patch_hessian.h"

namespace umbilic::UMBILIC_KERNELS {

extern const EnergyKernels kEnergyKernels{integrate, patch_hessian, integrate_all};

}  // namespace umbilic::UMBILIC_KERNELS
