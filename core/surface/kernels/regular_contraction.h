// SPDX-License-Identifier: MIT
/// \file
/// The contractions of surface/regular_kernel.h and their transposes.
#pragma once

#include "base/kernel_namespace.h"
#include "surface/surface_kernels.h"

namespace umbilic::UMBILIC_KERNELS {

/// See RegularKernel::jets and RegularKernel::pull_back.
void regular_jets(const RegularGrid& grid, const double* points, int derivatives, double* jets);
void pull_back_regular_jets(const RegularGrid& grid, const double* adjoint, int derivatives, double* gradient);

}  // namespace umbilic::UMBILIC_KERNELS
