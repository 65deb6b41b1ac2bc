// SPDX-License-Identifier: MIT
/// \file
/// The floating-point operations of an energy with its gradient, counted rather than measured.
#pragma once

#include "energy/functional.h"
#include "surface/layout.h"

namespace umbilic {

/// Of all samples with weight: basis, densities and pullbacks; not what padding, gathering and scattering cost.
double evaluation_flops(const PatchLayout& layout, const QuadratureRule& rule, const Weights& weights);

}  // namespace umbilic
