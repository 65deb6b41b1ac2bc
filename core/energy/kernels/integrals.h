// SPDX-License-Identifier: MIT
/// \file
/// Integrals over jet blocks, with adjoints.
#pragma once

#include "base/kernel_namespace.h"
#include "energy/energy_kernels.h"

namespace umbilic::UMBILIC_KERNELS {

/// See EnergyKernels.
void integrate(const double* weights, bool second_order, bool third_order, const JetBlock& block, EnergySums& sums);
void integrate_all(const JetBlock& block, FunctionalSums& sums);

}  // namespace umbilic::UMBILIC_KERNELS
