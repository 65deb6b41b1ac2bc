// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels: functions compiled once per instruction set, in the folder kernels/, and called through a
/// table.
#pragma once

#include <cstddef>

namespace umbilic {

/// The columns of a symmetric matrix that are eliminated together, with the rows below them: height x width,
/// column-major, of which the lower trapezoid counts.
struct DensePanel {
  double* values;
  int height, width;
};

/// The left factor B of a product B D B^T: rows x columns, column-major, `leading` doubles from one column to the next.
struct DenseFactor {
  const double* values;
  int leading, rows, columns;
};

/// Columns of a panel that are eliminated before all later ones are updated at once.
inline constexpr int kPanelBlock = 16;

/// Each function is documented where it is declared, in kernels/dense_elimination.h.
struct SolveKernels {
  bool (*eliminate_panel)(const DensePanel& panel, bool positive, double* pivots, double* scratch);
  bool (*eliminate_block)(const DensePanel& panel, int first, bool positive, double* pivots);
  void (*subtract_block)(const DensePanel& panel, int first, const double* pivots, int begin, int end, double* scratch);
  void (*subtract_product)(const DenseFactor& factor, const double* diagonal, int begin, int end, double* out,
                           double* scratch);
  std::size_t (*scratch_size)(int height);
};

/// The kernels of the instruction set in use.
const SolveKernels& solve_kernels();

}  // namespace umbilic
