// SPDX-License-Identifier: MIT
/// \file
/// Register tiles: a few lane vectors of rows by up to six points, and a few table columns by up to three points.
#include "surface/kernels/dense_product.h"

#include <cstddef>

#include "base/lanes.h"

namespace umbilic::UMBILIC_KERNELS {
namespace {

using Offset = std::ptrdiff_t;

/// Tile sizes, chosen by measurement: lane vectors of rows by six points, and table columns by three. The sums stay in
/// 16 registers, or 32 with AVX-512; WebAssembly's compilers need more of the registers for themselves.
#ifdef __wasm__
constexpr int kVectorsBySix = 1, kTall = 2;
#else
constexpr int kVectorsBySix = 2, kTall = kLaneCount == 8 ? 8 : 4;
#endif

/// Rows [row, row + kVectors lanes) of kWide consecutive columns of the product, which starts at `out`.
template <class L, int kVectors, int kWide>
void product_tile(const DenseTable& table, int row, const double* points, int width, double* out, int rows) {
  L sums[kVectors][kWide] = {};
  const double* entries = table.entries + row;
  for (int k = 0; k < table.columns; ++k, entries += table.stride, points += width) {
    L entry[kVectors];
    for (int v = 0; v < kVectors; ++v) entry[v] = load_lanes<L>(entries + v * kCount<L>);
    for (int c = 0; c < kWide; ++c) {
      const L point = splat<L>(points[c]);
      for (int v = 0; v < kVectors; ++v) sums[v][c] += entry[v] * point;
    }
  }
  for (int c = 0; c < kWide; ++c) {
    for (int v = 0; v < kVectors; ++v) store_lanes(out + Offset(c) * rows + row + v * kCount<L>, sums[v][c]);
  }
}

template <int kVectors, int kWide>
void product_columns(const DenseTable& table, int rows, const double* points, int width, double* out) {
  int row = 0;
  for (; row + kVectors * kLaneCount <= rows; row += kVectors * kLaneCount) {
    product_tile<Lanes, kVectors, kWide>(table, row, points, width, out, rows);
  }
  for (; row < rows; row += kShortLaneCount) {
    product_tile<ShortLanes, 1, kWide>(table, row, points, width, out, rows);
  }
}

/// Entries (k, c) of the transposed product for kTall table columns and kWide consecutive points.
template <int kColumns, int kWide>
void transposed_tile(const DenseTable& table, int k, int rows, const double* adjoint, int width, double* out) {
  ShortLanes sums[kColumns][kWide] = {};
  const double* entries = table.entries + Offset(k) * table.stride;
  for (int row = 0; row < rows; row += kShortLaneCount) {
    ShortLanes value[kWide];
    for (int c = 0; c < kWide; ++c) value[c] = load_lanes<ShortLanes>(adjoint + Offset(c) * rows + row);
    for (int i = 0; i < kColumns; ++i) {
      const ShortLanes entry = load_lanes<ShortLanes>(entries + Offset(i) * table.stride + row);
      for (int c = 0; c < kWide; ++c) sums[i][c] += entry * value[c];
    }
  }
  out += Offset(k) * width;
  for (int c = 0; c < kWide; ++c) {
    if constexpr (kColumns % 4 != 0) {
      for (int i = 0; i < kColumns; ++i) out[Offset(i) * width + c] = sum_lanes(sums[i][c]);
    } else {
      for (int i = 0; i < kColumns; i += 4) {
        double totals[4];
        sum_lanes_of_four({sums[i][c], sums[i + 1][c], sums[i + 2][c], sums[i + 3][c]}, totals);
        for (int j = 0; j < 4; ++j) out[Offset(i + j) * width + c] = totals[j];
      }
    }
  }
}

template <int kWide>
void transposed_columns(const DenseTable& table, int rows, const double* adjoint, int width, double* out) {
  int k = 0;
  for (; k + kTall <= table.columns; k += kTall) {
    transposed_tile<kTall, kWide>(table, k, rows, adjoint, width, out);
  }
  for (; k < table.columns; ++k) transposed_tile<1, kWide>(table, k, rows, adjoint, width, out);
}

}  // namespace

void dense_product(const DenseTable& table, int rows, const double* points, int width, double* out) {
  int c = 0;
  for (; c + 6 <= width; c += 6)
    product_columns<kVectorsBySix, 6>(table, rows, points + c, width, out + Offset(c) * rows);
  for (; c + 3 <= width; c += 3) product_columns<2, 3>(table, rows, points + c, width, out + Offset(c) * rows);
  for (; c + 2 <= width; c += 2) product_columns<4, 2>(table, rows, points + c, width, out + Offset(c) * rows);
  if (c < width) product_columns<4, 1>(table, rows, points + c, width, out + Offset(c) * rows);
}

void dense_transposed_product(const DenseTable& table, int rows, const double* adjoint, int width, double* out) {
  int c = 0;
  for (; c + 3 <= width; c += 3) transposed_columns<3>(table, rows, adjoint + Offset(c) * rows, width, out + c);
  for (; c + 2 <= width; c += 2) transposed_columns<2>(table, rows, adjoint + Offset(c) * rows, width, out + c);
  if (c < width) transposed_columns<1>(table, rows, adjoint + Offset(c) * rows, width, out + c);
}

}  // namespace umbilic::UMBILIC_KERNELS
