// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels: functions compiled once per instruction set, in the folder kernels/, and called through a
/// table.
#pragma once

namespace umbilic {

/// The basis of a tensor grid of nodes on a regular face; see surface/regular_kernel.h.
struct RegularGrid {
  int points, width;      ///< nodes per direction; the same along u with padding
  const double* along_u;  ///< [k][a][i], i < width
  const double* along_v;  ///< [l][j][b]
  double* partial;        ///< scratch memory, [c][k][b][i]
};

/// Basis derivatives at samples, column by column.
struct DenseTable {
  const double* entries;
  int stride;   ///< doubles from one column to the next
  int columns;  ///< local points
};

/// Each function is documented where it is declared, in kernels/.
struct SurfaceKernels {
  void (*regular_jets)(const RegularGrid& grid, const double* points, int derivatives, double* jets);
  void (*pull_back_regular_jets)(const RegularGrid& grid, const double* adjoint, int derivatives, double* gradient);
  void (*dense_product)(const DenseTable& table, int rows, const double* points, int width, double* out);
  void (*dense_transposed_product)(const DenseTable& table, int rows, const double* adjoint, int width, double* out);
};

/// The kernels of the instruction set in use.
const SurfaceKernels& surface_kernels();

}  // namespace umbilic
