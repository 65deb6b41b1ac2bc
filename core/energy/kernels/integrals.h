// SPDX-License-Identifier: MIT
/// \file
/// Integrals over jet blocks, with adjoints.
#pragma once

#include "base/kernel_namespace.h"
#include "energy/energy_kernels.h"

namespace umbilic::UMBILIC_KERNELS {

/// See EnergyKernels.
BlockEnergies integrate(const double* weights, const AreaPowers& powers, const JetBlock& block);
FunctionalSums integrate_all(const JetBlock& block);

}  // namespace umbilic::UMBILIC_KERNELS
