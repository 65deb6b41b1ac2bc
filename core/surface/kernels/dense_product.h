// SPDX-License-Identifier: MIT
/// \file
/// Products of a tall table with a narrow block of points, and the transpose, in lanes over the table's rows.
///
/// The library's general matrix product has no kernel for WebAssembly; these loops compile to good code everywhere
/// because the shapes are known: thousands of rows, tens of columns, a multiple of three points.
#pragma once

#include "base/kernel_namespace.h"

namespace umbilic::inline UMBILIC_INSTRUCTION_SET {

/// out (rows x 3 patches, column-major) = table (rows x columns, column-major, leading dimension `stride`) times
/// points (columns x 3 patches, row-major). `rows` is a multiple of kSampleMultiple.
void dense_product(const double* table, int stride, int rows, int columns, const double* points, int patches,
                   double* out);

/// out (columns x 3 patches, row-major) = table^T times adjoint (rows x 3 patches, column-major).
void dense_transposed_product(const double* table, int stride, int rows, int columns, const double* adjoint,
                              int patches, double* out);

}  // namespace umbilic::inline UMBILIC_INSTRUCTION_SET
