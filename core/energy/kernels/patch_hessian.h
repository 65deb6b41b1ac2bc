// SPDX-License-Identifier: MIT
/// \file
/// Second derivatives of one patch's integral by its local points: W^T D W, with D the Hessians of the jets and W the
/// basis.
#pragma once

#include "base/kernel_namespace.h"
#include "energy/energy_kernels.h"

namespace umbilic::UMBILIC_KERNELS {

/// See EnergyKernels.
void patch_hessian(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out);

}  // namespace umbilic::UMBILIC_KERNELS
