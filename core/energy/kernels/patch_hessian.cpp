// SPDX-License-Identifier: MIT
/// \file
/// Contracts the jets' Hessians with the basis, several samples at a time.
#include "energy/kernels/patch_hessian.h"

#include "base/lanes.h"
#include "energy/jet_lanes.h"
#include "energy/kernels/jet_hessian.h"

namespace umbilic::UMBILIC_KERNELS {
namespace {

using L = ShortLanes;

constexpr int kPairs = 6;
constexpr int kFirst[kPairs] = {0, 1, 1, 2, 2, 2}, kSecond[kPairs] = {0, 0, 1, 0, 1, 2};

/// products[d * columns + j] = sum over e of D(c, d; other, e) times basis function j's derivative e.
template <int kDerivatives, class Hessian>
void apply(const Hessian& hessian, int c, int other, const double* basis, int stride, int samples, int columns,
           L* products) {
  constexpr int kTall = kDerivatives == kThirdOrderCount ? 3 : 5, kWide = kDerivatives == kThirdOrderCount ? 4 : 2;
  for (int j = 0; j < columns; j += kWide) {
    for (int d = 0; d < kDerivatives; d += kTall) {
      L tile[kTall][kWide] = {};
      for (int e = 0; e < kDerivatives; ++e) {
        L function[kWide];
        for (int b = 0; b < kWide; ++b) function[b] = load_lanes<L>(basis + (j + b) * stride + e * samples);
        for (int a = 0; a < kTall; ++a) {
          const L entry = hessian(c * kDerivatives + d + a, other * kDerivatives + e);
          for (int b = 0; b < kWide; ++b) tile[a][b] += entry * function[b];
        }
      }
      for (int a = 0; a < kTall; ++a) {
        for (int b = 0; b < kWide; ++b) products[(d + a) * columns + j + b] = tile[a][b];
      }
    }
  }
}

/// sums[i * columns + j] += sum over d of basis function i's derivative d times products[d][j], a tile of 4 x 2 at a
/// time.
template <int kDerivatives>
void accumulate(const double* basis, int stride, int samples, int columns, const L* products, bool symmetric, L* sums) {
  for (int i = 0; i < columns; i += 4) {
    const double* row = basis + i * stride;
    const int last = symmetric ? i + 4 : columns;
    for (int j = 0; j < last; j += 2) {
      L tile[4][2];
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 2; ++b) tile[a][b] = sums[(i + a) * columns + j + b];
      }
      for (int d = 0; d < kDerivatives; ++d) {
        const L left = products[d * columns + j], right = products[d * columns + j + 1];
        for (int a = 0; a < 4; ++a) {
          const L function = load_lanes<L>(row + a * stride + d * samples);
          tile[a][0] += function * left;
          tile[a][1] += function * right;
        }
      }
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 2; ++b) sums[(i + a) * columns + j + b] = tile[a][b];
      }
    }
  }
}

/// The next multiple of the size of lanes.
void* aligned(double* scratch) {
  const auto address = reinterpret_cast<__UINTPTR_TYPE__>(scratch);
  return scratch + (sizeof(L) - address % sizeof(L)) % sizeof(L) / sizeof(double);
}

template <bool kThird>
void contract(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out) {
  constexpr int kDerivatives = kThird ? kThirdOrderCount : kSecondOrderCount;
  const int columns = patch.columns, block = columns * columns;
  L* sums = static_cast<L*>(aligned(scratch));
  L* products = sums + kPairs * block;
  for (int i = 0; i < kPairs * block; ++i) sums[i] = L{};
  for (int s = 0; s < patch.samples; s += kShortLaneCount) {
    const Jet<L> jet = load_jet<kThird, L>(patch.jets + s, patch.samples, kThirdOrderCount);
    const JetHessian<kThird, L> hessian(f, jet, load_lanes<L>(patch.weights + s));
    for (int pair = 0; pair < kPairs; ++pair) {
      const int c = kFirst[pair], other = kSecond[pair];
      apply<kDerivatives>(hessian, c, other, patch.basis[other] + s, patch.stride, patch.samples, columns, products);
      accumulate<kDerivatives>(patch.basis[c] + s, patch.stride, patch.samples, columns, products, c == other,
                               sums + pair * block);
    }
  }
  for (int pair = 0; pair < kPairs; ++pair) {
    double* to = out + kFirst[pair] * columns * 3 * columns + kSecond[pair] * columns;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < columns; ++j) to[i * 3 * columns + j] = sum_lanes(sums[pair * block + i * columns + j]);
    }
  }
}

}  // namespace

void patch_hessian(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out) {
  f.third_order ? contract<true>(patch, f, scratch, out) : contract<false>(patch, f, scratch, out);
}

}  // namespace umbilic::UMBILIC_KERNELS
