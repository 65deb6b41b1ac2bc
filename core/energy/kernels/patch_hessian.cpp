// SPDX-License-Identifier: MIT
/// \file
/// Multiplies the Hessians of the jets by the basis from both sides, several samples at a time.
///
/// For each pair of coordinates the patch's matrix is B^T (D B), with B the basis functions' derivatives at all samples
/// and D the Hessians of the jets. The product of these long columns is done in tiles that stay in registers.
#include "energy/kernels/patch_hessian.h"

#include "base/lanes.h"
#include "energy/jet_lanes.h"
#include "energy/kernels/jet_hessian.h"

namespace umbilic::UMBILIC_KERNELS {
namespace {

using L = ShortLanes;

constexpr int kPairs = 6;
constexpr int kFirst[kPairs] = {0, 1, 1, 2, 2, 2}, kSecond[kPairs] = {0, 0, 1, 0, 1, 2};

/// Tile sizes of basis functions; the sums of a tile stay in registers.
constexpr int kTileRows = 4, kTileColumns = kLaneCount == 8 ? 4 : 2;

/// The samples [begin, begin + count) of a patch. A packed column has a row for each derivative and sample, padded with
/// zeros to a multiple of the lanes.
struct Part {
  int begin, count;
  int rows, stride;

  Part(int first, int samples, int derivatives)
      : begin(first),
        count(samples),
        rows(derivatives * samples),
        stride((rows + kLaneCount - 1) / kLaneCount * kLaneCount) {}
};

/// packed[column * stride + d * count + s]: the basis functions' derivatives at the part's samples.
template <int kDerivatives>
void pack(const Part& part, const double* basis, const HessianPatch& patch, double* packed) {
  for (int j = 0; j < patch.columns; ++j, basis += patch.stride, packed += part.stride) {
    for (int d = 0; d < kDerivatives; ++d) {
      for (int s = 0; s < part.count; s += kShortLaneCount) {
        store_lanes(packed + d * part.count + s, load_lanes<L>(basis + d * patch.samples + part.begin + s));
      }
    }
    for (int row = part.rows; row < part.stride; ++row) packed[row] = 0;
  }
}

/// The Hessians of the jets at the part's samples: entry (d, e) for each pair of coordinates, [pair][d][e][s].
template <bool kThird, bool kChristoffel>
void jet_hessians(const Part& part, const HessianPatch& patch, const WeightedIntegrand& f, double* hessians) {
  constexpr int kDerivatives = kThird ? kThirdOrderCount : kSecondOrderCount;
  for (int s = 0; s < part.count; s += kShortLaneCount) {
    const double* jets = patch.jets + part.begin + s;
    const Jet<L> jet = load_jet<kThird, L>(jets, patch.samples, kDerivatives);
    const JetHessian<kThird, kChristoffel, L> hessian(f, jet, load_lanes<L>(patch.weights + part.begin + s));
    double* to = hessians + s;
    for (int pair = 0; pair < kPairs; ++pair) {
      for (int d = 0; d < kDerivatives; ++d) {
        for (int e = 0; e < kDerivatives; ++e, to += part.count) {
          store_lanes(to, hessian(kFirst[pair] * kDerivatives + d, kSecond[pair] * kDerivatives + e));
        }
      }
    }
  }
}

/// For a few columns and samples, starting at s: products = sum over e of D(d, e) times derivative e of the basis
/// function.
template <int kDerivatives, class Samples>
void apply_tile(const Part& part, const double* hessians, const double* packed, double* products) {
  constexpr int kTall = kDerivatives == kThirdOrderCount ? 3 : 5, kWide = kDerivatives == kThirdOrderCount ? 4 : 2;
  for (int column = 0; column < HessianPatch::kColumnMultiple; column += kWide) {
    const double* functions = packed + column * part.stride;
    for (int d = 0; d < kDerivatives; d += kTall) {
      Samples tile[kTall][kWide] = {};
      for (int e = 0; e < kDerivatives; ++e) {
        Samples function[kWide];
        for (int b = 0; b < kWide; ++b) {
          function[b] = load_lanes<Samples>(functions + b * part.stride + e * part.count);
        }
        for (int a = 0; a < kTall; ++a) {
          const Samples entry = load_lanes<Samples>(hessians + ((d + a) * kDerivatives + e) * part.count);
          for (int b = 0; b < kWide; ++b) tile[a][b] += entry * function[b];
        }
      }
      for (int a = 0; a < kTall; ++a) {
        for (int b = 0; b < kWide; ++b) {
          store_lanes(products + (column + b) * part.stride + (d + a) * part.count, tile[a][b]);
        }
      }
    }
  }
}

/// products[column * stride + d * count + s] for all columns and samples.
template <int kDerivatives>
void apply(const Part& part, const double* hessians, const double* packed, int columns, double* products) {
  for (int j = 0; j < columns; j += HessianPatch::kColumnMultiple) {
    const int at = j * part.stride;
    int s = 0;
    for (; s + kLaneCount <= part.count; s += kLaneCount) {
      apply_tile<kDerivatives, Lanes>(part, hessians + s, packed + at + s, products + at + s);
    }
    for (; s < part.count; s += kShortLaneCount) {
      apply_tile<kDerivatives, L>(part, hessians + s, packed + at + s, products + at + s);
    }
  }
}

/// sums[i * row_length + j] += column i of `packed` times column j of `products`, a tile at a time.
void accumulate(const Part& part, const double* packed, const double* products, int columns, bool symmetric,
                double* sums, int row_length) {
  for (int i = 0; i < columns; i += kTileRows) {
    const int last = symmetric ? i + kTileRows : columns;
    for (int j = 0; j < last; j += kTileColumns) {
      const double *left = packed + i * part.stride, *right = products + j * part.stride;
      Lanes tile[kTileRows][kTileColumns] = {};
      for (int row = 0; row < part.stride; row += kLaneCount) {
        Lanes product[kTileColumns];
        for (int b = 0; b < kTileColumns; ++b) product[b] = load_lanes(right + b * part.stride + row);
        for (int a = 0; a < kTileRows; ++a) {
          const Lanes function = load_lanes(left + a * part.stride + row);
          for (int b = 0; b < kTileColumns; ++b) tile[a][b] += function * product[b];
        }
      }
      for (int b = 0; b < kTileColumns; ++b) {
        double totals[kTileRows];
        sum_lanes_of_four({fold(tile[0][b]), fold(tile[1][b]), fold(tile[2][b]), fold(tile[3][b])}, totals);
        for (int a = 0; a < kTileRows; ++a) sums[(i + a) * row_length + j + b] += totals[a];
      }
    }
  }
}

/// The first address in `scratch` that is aligned to lanes.
double* aligned(double* scratch) {
  const auto address = reinterpret_cast<__UINTPTR_TYPE__>(scratch);
  return scratch + (sizeof(Lanes) - address % sizeof(Lanes)) % sizeof(Lanes) / sizeof(double);
}

template <bool kThird, bool kChristoffel>
void contract(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out) {
  constexpr int kDerivatives = kThird ? kThirdOrderCount : kSecondOrderCount;
  constexpr int kAtATime = kThird ? HessianPatch::kThirdOrderSamplesAtATime : HessianPatch::kSamplesAtATime;
  const int columns = patch.columns, row_length = 3 * columns;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < columns; ++i) {
      double* row = out + (c * columns + i) * row_length;
      for (int j = 0; j < (c + 1) * columns; ++j) row[j] = 0;
    }
  }
  double* hessians = aligned(scratch);
  for (int begin = 0; begin < patch.samples; begin += kAtATime) {
    const Part part(begin, patch.samples - begin < kAtATime ? patch.samples - begin : kAtATime, kDerivatives);
    const int per_pair = kDerivatives * kDerivatives * part.count;
    double* packed[3] = {hessians + kPairs * per_pair, nullptr, nullptr};
    double* products = packed[0] + 2 * columns * part.stride;
    jet_hessians<kThird, kChristoffel>(part, patch, f, hessians);
    pack<kDerivatives>(part, patch.basis[0], patch, packed[0]);
    for (int c = 1; c < 3; ++c) {
      packed[c] = packed[0];
      if (patch.basis[c] == patch.basis[0]) continue;
      packed[c] = packed[0] + columns * part.stride;
      if (patch.basis[c] != patch.basis[c - 1]) pack<kDerivatives>(part, patch.basis[c], patch, packed[c]);
    }
    for (int j = 0; j < columns; ++j) {
      for (int row = part.rows; row < part.stride; ++row) products[j * part.stride + row] = 0;
    }
    for (int pair = 0; pair < kPairs; ++pair) {
      const int c = kFirst[pair], other = kSecond[pair];
      apply<kDerivatives>(part, hessians + pair * per_pair, packed[other], columns, products);
      accumulate(part, packed[c], products, columns, c == other, out + c * columns * row_length + other * columns,
                 row_length);
    }
  }
}

}  // namespace

void patch_hessian(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out) {
  const bool christoffel = f.weights[kParametrization] != 0;
  if (f.third_order) {
    christoffel ? contract<true, true>(patch, f, scratch, out) : contract<true, false>(patch, f, scratch, out);
  } else {
    christoffel ? contract<false, true>(patch, f, scratch, out) : contract<false, false>(patch, f, scratch, out);
  }
}

}  // namespace umbilic::UMBILIC_KERNELS
