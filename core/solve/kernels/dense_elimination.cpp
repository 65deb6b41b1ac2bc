// SPDX-License-Identifier: MIT
/// \file
/// Blocks of columns are eliminated one after the other; what a block subtracts from later columns is a product that is
/// computed by tiles which stay in registers, from copies of its factors in the order in which tiles read them.
/// K. Goto, R. van de Geijn: Anatomy of high-performance matrix multiplication, ACM TOMS 34 (2008).
#include "solve/kernels/dense_elimination.h"

#include "base/lanes.h"

namespace umbilic::UMBILIC_KERNELS {
namespace {

using Offset = std::ptrdiff_t;

/// A tile's rows are kVectors lane vectors, its sums kVectors kTileColumns: what fits the registers of the set.
#if defined(__AVX512F__)
constexpr int kVectors = 3, kTileColumns = 8;
#elif defined(__AVX2__)
constexpr int kVectors = 3, kTileColumns = 4;
#else
constexpr int kVectors = 2, kTileColumns = 4;
#endif
constexpr int kTileRows = kVectors * kLaneCount;

constexpr int kBlock = kPanelBlock;
/// Largest number of terms of a sum whose factors are copied at once: as many as keep a tile's factors in the first
/// cache.
constexpr int kDepth = 128;

constexpr int rounded_up(int n, int step) { return (n + step - 1) / step * step; }

/// Copies `depth` columns of `from` (rows x depth, column-major), each scaled, group by group of kGroup rows: entry (i,
/// p) goes to to[(i / kGroup) depth kGroup + p kGroup + i % kGroup]. Rows that the last group lacks are 0.
template <int kGroup>
void copy_groups(const double* from, int leading, int rows, int depth, const double* scales, double* to) {
  for (int first = 0; first < rows; first += kGroup) {
    const int count = rows - first < kGroup ? rows - first : kGroup;
    for (int p = 0; p < depth; ++p, to += kGroup) {
      const double* column = from + Offset(p) * leading + first;
      const double scale = scales ? scales[p] : 1;
      for (int i = 0; i < count; ++i) to[i] = scale * column[i];
      for (int i = count; i < kGroup; ++i) to[i] = 0;
    }
  }
}

/// Where a tile of kTileRows x kTileColumns is subtracted. The edges or the diagonal of the matrix may cut it.
struct Tile {
  double* out;
  int leading;
  int rows, columns;  ///< from the tile's first to the end of the matrix
  int diagonal;       ///< entries (i, j) of the tile with j <= i + diagonal are in the lower triangle
};

inline void subtract_tile(const double* a, const double* b, int depth, const Tile& tile) {
  Lanes sums[kTileColumns][kVectors] = {};
  for (int p = 0; p < depth; ++p, a += kTileRows, b += kTileColumns) {
    Lanes left[kVectors];
    for (int v = 0; v < kVectors; ++v) left[v] = load_lanes<Lanes>(a + v * kLaneCount);
    for (int j = 0; j < kTileColumns; ++j) {
      const Lanes right = splat<Lanes>(b[j]);
      for (int v = 0; v < kVectors; ++v) sums[j][v] += left[v] * right;
    }
  }
  if (tile.rows >= kTileRows && tile.columns >= kTileColumns && tile.diagonal >= kTileColumns - 1) {
    for (int j = 0; j < kTileColumns; ++j) {
      double* column = tile.out + Offset(j) * tile.leading;
      for (int v = 0; v < kVectors; ++v) {
        double* at = column + v * kLaneCount;
        store_lanes(at, load_lanes<Lanes>(at) - sums[j][v]);
      }
    }
    return;
  }
  double values[kTileColumns][kTileRows];
  for (int j = 0; j < kTileColumns; ++j) {
    for (int v = 0; v < kVectors; ++v) store_lanes(values[j] + v * kLaneCount, sums[j][v]);
  }
  const int rows = tile.rows < kTileRows ? tile.rows : kTileRows;
  for (int j = 0; j < kTileColumns && j < tile.columns; ++j) {
    double* column = tile.out + Offset(j) * tile.leading;
    const int first = j > tile.diagonal ? j - tile.diagonal : 0;
    for (int i = first; i < rows; ++i) column[i] -= values[j][i];
  }
}

/// out -= the lower trapezoid of A D C^T, where A is rows x depth, C its first `columns` rows, and D the pivots.
void subtract_trapezoid(const double* a, int leading, int rows, int columns, int depth, const double* pivots,
                        double* out, int out_leading, double* scratch) {
  for (int done = 0; done < depth; done += kDepth) {
    const int count = depth - done < kDepth ? depth - done : kDepth;
    double* left = scratch;
    double* right = scratch + Offset(rounded_up(rows, kTileRows)) * count;
    copy_groups<kTileRows>(a + Offset(done) * leading, leading, rows, count, nullptr, left);
    copy_groups<kTileColumns>(a + Offset(done) * leading, leading, columns, count, pivots + done, right);
    for (int j = 0; j < columns; j += kTileColumns) {
      for (int i = j / kTileRows * kTileRows; i < rows; i += kTileRows) {
        const Tile tile{out + Offset(j) * out_leading + i, out_leading, rows - i, columns - j, i - j};
        subtract_tile(left + Offset(i) * count, right + Offset(j) * count, count, tile);
      }
    }
  }
}

/// L and D of a small square, row by row.
struct Square {
  double lower[kBlock][kBlock];
  double pivots[kBlock];
};

bool eliminate_square(double* values, int leading, int count, bool positive, Square& square) {
  for (int j = 0; j < count; ++j) {
    double* column = values + Offset(j) * leading;
    const double pivot = column[j];
    if (!(positive ? pivot > 0 : pivot != 0) || !(pivot - pivot == 0)) return false;
    square.pivots[j] = pivot;
    for (int i = j + 1; i < count; ++i) square.lower[i][j] = column[i] / pivot;
    for (int k = j + 1; k < count; ++k) {
      double* later = values + Offset(k) * leading;
      for (int i = k; i < count; ++i) later[i] -= square.lower[k][j] * column[i];
    }
    for (int i = j + 1; i < count; ++i) column[i] = square.lower[i][j];
  }
  return true;
}

/// Turns rows below an eliminated square into rows of L. `Row` is one row or a lane vector of them; columns beyond
/// `count` are not there.
template <int kColumns, class Row, class Load, class Store>
void solve_rows(const Square& square, int count, Load load, Store store) {
  Row scaled[kColumns];
  for (int j = 0; j < kColumns; ++j) {
    scaled[j] = j < count ? load(j) : Row{};
    for (int k = 0; k < j; ++k) scaled[j] -= scaled[k] * square.lower[j][k];
  }
  for (int j = 0; j < count; ++j) store(j, scaled[j] / square.pivots[j]);
}

template <int kColumns>
void solve_below(const Square& square, double* values, int leading, int rows, int count) {
  int i = 0;
  for (; i + kLaneCount <= rows; i += kLaneCount) {
    solve_rows<kColumns, Lanes>(
        square, count, [&](int j) { return load_lanes<Lanes>(values + Offset(j) * leading + i); },
        [&](int j, Lanes x) { store_lanes(values + Offset(j) * leading + i, x); });
  }
  for (; i < rows; ++i) {
    solve_rows<kColumns, double>(
        square, count, [&](int j) { return values[Offset(j) * leading + i]; },
        [&](int j, double x) { values[Offset(j) * leading + i] = x; });
  }
}

int block_width(const DensePanel& panel, int first) {
  return panel.width - first < kBlock ? panel.width - first : kBlock;
}

}  // namespace

bool eliminate_block(const DensePanel& panel, int first, bool positive, double* pivots) {
  const int count = block_width(panel, first);
  double* corner = panel.values + Offset(first) * panel.height + first;
  Square square{};
  if (!eliminate_square(corner, panel.height, count, positive, square)) return false;
  for (int j = 0; j < count; ++j) pivots[first + j] = square.pivots[j];
  const int rows = panel.height - first - count;
  if (count > 8) {
    solve_below<kBlock>(square, corner + count, panel.height, rows, count);
  } else {
    solve_below<8>(square, corner + count, panel.height, rows, count);
  }
  return true;
}

void subtract_block(const DensePanel& panel, int first, const double* pivots, int begin, int end, double* scratch) {
  subtract_trapezoid(panel.values + Offset(first) * panel.height + begin, panel.height, panel.height - begin,
                     end - begin, block_width(panel, first), pivots + first,
                     panel.values + Offset(begin) * panel.height + begin, panel.height, scratch);
}

bool eliminate_panel(const DensePanel& panel, bool positive, double* pivots, double* scratch) {
  for (int first = 0; first < panel.width; first += kBlock) {
    if (!eliminate_block(panel, first, positive, pivots)) return false;
    const int next = first + kBlock;
    if (next < panel.width) subtract_block(panel, first, pivots, next, panel.width, scratch);
  }
  return true;
}

void subtract_product(const DenseFactor& factor, const double* diagonal, int begin, int end, double* out,
                      double* scratch) {
  subtract_trapezoid(factor.values + begin, factor.leading, factor.rows - begin, end - begin, factor.columns, diagonal,
                     out + Offset(begin) * factor.rows + begin, factor.rows, scratch);
}

std::size_t scratch_size(int height) {
  return static_cast<std::size_t>(rounded_up(height, kTileRows) + rounded_up(height, kTileColumns)) * kDepth;
}

}  // namespace umbilic::UMBILIC_KERNELS
