// SPDX-License-Identifier: MIT
/// \file
/// The dense work of a sparse factorization: L D L^T of a panel of columns, and what it subtracts from later ones.
#pragma once

#include "base/kernel_namespace.h"
#include "solve/solve_kernels.h"

namespace umbilic::UMBILIC_KERNELS {

/// Turns the panel's columns into those of L, the unit diagonal understood, and writes D to `pivots`; the panel's
/// diagonal is left with D. Returns false, with the panel spoilt, at the first pivot that is not finite, or 0, or, if
/// `positive`, not above 0.
bool eliminate_panel(const DensePanel& panel, bool positive, double* pivots, double* scratch);

/// The same for the kPanelBlock columns from `first` on, or as many as there are, once those before `first` are
/// eliminated and subtracted.
bool eliminate_block(const DensePanel& panel, int first, bool positive, double* pivots);

/// Subtracts from the columns [begin, end) of the panel what the block from `first` on contributes. Gives the same bits
/// however columns are divided.
void subtract_block(const DensePanel& panel, int first, const double* pivots, int begin, int end, double* scratch);

/// Subtracts the columns [begin, end) of the lower triangle of B D B^T from `out`, column-major with as many rows as B
/// has; D is diagonal. Above the diagonal `out` is not touched. Gives the same bits however columns are divided.
void subtract_product(const DenseFactor& factor, const double* diagonal, int begin, int end, double* out,
                      double* scratch);

/// How many doubles of scratch memory a panel of this height, or a factor with so many rows, needs.
std::size_t scratch_size(int height);

}  // namespace umbilic::UMBILIC_KERNELS
