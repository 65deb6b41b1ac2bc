// SPDX-License-Identifier: MIT
/// \file
/// Floating-point operations, counted rather than measured.
#pragma once

#include <Eigen/SparseCore>

#include "energy/functional.h"
#include "surface/layout.h"

namespace umbilic {

/// Of an energy with its gradient, all samples with weight: basis, densities and pullbacks; not what padding, gathering
/// and scattering cost.
double evaluation_flops(const PatchLayout& layout, const QuadratureRule& rule, const Weights& weights);

/// Of the factorization of the matrix with this lower triangle.
double factorization_flops(const Eigen::SparseMatrix<double>& lower);

}  // namespace umbilic
