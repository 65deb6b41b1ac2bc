// SPDX-License-Identifier: MIT
/// \file
/// Products of a tall table with a few points, and the transposed products, vectorized over the table's rows.
///
/// Eigen's matrix product has no kernel for WebAssembly. These loops compile to good code everywhere because the shapes
/// are known: thousands of rows, tens of columns, and a few points, usually a multiple of three.
#pragma once

#include "base/kernel_namespace.h"
#include "surface/surface_kernels.h"

namespace umbilic::UMBILIC_KERNELS {

/// out (rows x width, column-major) = the table's first `rows` rows times points (columns x width, row-major). `rows`
/// is a multiple of kSampleMultiple.
void dense_product(const DenseTable& table, int rows, const double* points, int width, double* out);

/// out (columns x width, row-major) = the transpose of the table's first `rows` rows times adjoint (rows x width,
/// column-major).
void dense_transposed_product(const DenseTable& table, int rows, const double* adjoint, int width, double* out);

}  // namespace umbilic::UMBILIC_KERNELS
