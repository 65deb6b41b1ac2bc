// SPDX-License-Identifier: MIT
/// \file
/// Register tiles: two lane vectors of rows by one or two patches, and three table columns by one patch.
#include "surface/kernels/dense_product.h"

#include <cstddef>

#include "base/lanes.h"

namespace umbilic::inline UMBILIC_INSTRUCTION_SET {
namespace {

/// Rows [row, row + kVectors lanes) of kWide consecutive columns of the product.
template <class L, int kVectors, int kWide>
void product_tile(const double* table, int stride, int columns, const double* points, int width, double* out,
                  int rows) {
  L sums[kVectors][kWide] = {};
  for (int k = 0; k < columns; ++k, table += stride, points += width) {
    L entry[kVectors];
    for (int v = 0; v < kVectors; ++v) entry[v] = load_lanes<L>(table + v * kCount<L>);
    for (int c = 0; c < kWide; ++c) {
      const L point = splat<L>(points[c]);
      for (int v = 0; v < kVectors; ++v) sums[v][c] += entry[v] * point;
    }
  }
  for (int c = 0; c < kWide; ++c) {
    for (int v = 0; v < kVectors; ++v)
      store_lanes(out + static_cast<std::ptrdiff_t>(c) * rows + v * kCount<L>, sums[v][c]);
  }
}

template <int kWide>
void product_columns(const double* table, int stride, int rows, int columns, const double* points, int width,
                     double* out) {
  int row = 0;
  for (; row + 2 * kLaneCount <= rows; row += 2 * kLaneCount) {
    product_tile<Lanes, 2, kWide>(table + row, stride, columns, points, width, out + row, rows);
  }
  for (; row < rows; row += kShortLaneCount) {
    product_tile<ShortLanes, 1, kWide>(table + row, stride, columns, points, width, out + row, rows);
  }
}

/// Adds rows [row, last) to entries (k, c) of the transposed product for kTall table columns and the three coordinates
/// of a patch, in lanes; returns the first row that is left.
template <int kTall, class L>
int transposed_rows(const double* table, int stride, int rows, int row, const double* adjoint, L (&sums)[kTall][3]) {
  for (; row + kCount<L> <= rows; row += kCount<L>) {
    L value[3];
    for (int c = 0; c < 3; ++c) value[c] = load_lanes<L>(adjoint + static_cast<std::ptrdiff_t>(c) * rows + row);
    for (int k = 0; k < kTall; ++k) {
      const L entry = load_lanes<L>(table + static_cast<std::ptrdiff_t>(k) * stride + row);
      for (int c = 0; c < 3; ++c) sums[k][c] += entry * value[c];
    }
  }
  return row;
}

template <int kTall>
void transposed_tile(const double* table, int stride, int rows, const double* adjoint, int width, double* out) {
  Lanes sums[kTall][3] = {};
  ShortLanes rest[kTall][3] = {};
  const int row = transposed_rows<kTall, Lanes>(table, stride, rows, 0, adjoint, sums);
  if constexpr (kShortLaneCount < kLaneCount) {
    transposed_rows<kTall, ShortLanes>(table, stride, rows, row, adjoint, rest);
  }
  for (int c = 0; c < 3; ++c) {
    ShortLanes folded[4] = {};
    for (int k = 0; k < kTall; ++k) folded[k] = fold(sums[k][c]) + rest[k][c];
    double totals[4];
    sum_lanes_of_four(folded, totals);
    for (int k = 0; k < kTall; ++k) out[static_cast<std::ptrdiff_t>(k) * width + c] = totals[k];
  }
}

}  // namespace

void dense_product(const double* table, int stride, int rows, int columns, const double* points, int patches,
                   double* out) {
  const int width = 3 * patches;
  int column = 0;
  for (; column + 6 <= width; column += 6) {
    product_columns<6>(table, stride, rows, columns, points + column, width,
                       out + static_cast<std::ptrdiff_t>(column) * rows);
  }
  if (column < width) {
    product_columns<3>(table, stride, rows, columns, points + column, width,
                       out + static_cast<std::ptrdiff_t>(column) * rows);
  }
}

void dense_transposed_product(const double* table, int stride, int rows, int columns, const double* adjoint,
                              int patches, double* out) {
  const int width = 3 * patches;
  for (int patch = 0; patch < patches; ++patch) {
    const double* values = adjoint + static_cast<std::ptrdiff_t>(3 * patch) * rows;
    int k = 0;
    for (; k + 4 <= columns; k += 4) {
      transposed_tile<4>(table + static_cast<std::ptrdiff_t>(k) * stride, stride, rows, values, width,
                         out + static_cast<std::ptrdiff_t>(k) * width + 3 * patch);
    }
    for (; k < columns; ++k) {
      transposed_tile<1>(table + static_cast<std::ptrdiff_t>(k) * stride, stride, rows, values, width,
                         out + static_cast<std::ptrdiff_t>(k) * width + 3 * patch);
    }
  }
}

}  // namespace umbilic::inline UMBILIC_INSTRUCTION_SET
