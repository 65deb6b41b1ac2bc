// SPDX-License-Identifier: MIT
/// \file
/// Contracts the jets' Hessians with the basis, several samples at a time.
#include "energy/patch_hessian.h"

#include "base/lanes.h"
#include "energy/jet_hessian.h"
#include "energy/jet_lanes.h"

namespace umbilic {
namespace {

constexpr int kPairs = 6;
constexpr int kFirst[kPairs] = {0, 1, 1, 2, 2, 2}, kSecond[kPairs] = {0, 0, 1, 0, 1, 2};

/// products[d * columns + j] = sum over e of D(c, d; other, e) times basis function j's derivative e.
template <int kDerivatives, class Hessian>
void apply(const Hessian& hessian, int c, int other, const double* basis, int stride, int samples, int columns,
           Lanes* products) {
  constexpr int kTall = kDerivatives == kThirdOrderCount ? 3 : 5, kWide = kDerivatives == kThirdOrderCount ? 4 : 2;
  for (int j = 0; j < columns; j += kWide) {
    for (int d = 0; d < kDerivatives; d += kTall) {
      Lanes tile[kTall][kWide] = {};
      for (int e = 0; e < kDerivatives; ++e) {
        Lanes function[kWide];
        for (int b = 0; b < kWide; ++b) function[b] = load_lanes(basis + (j + b) * stride + e * samples);
        for (int a = 0; a < kTall; ++a) {
          const Lanes entry = hessian(c * kDerivatives + d + a, other * kDerivatives + e);
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
void accumulate(const double* basis, int stride, int samples, int columns, const Lanes* products, bool symmetric,
                Lanes* sums) {
  for (int i = 0; i < columns; i += 4) {
    const double* row = basis + i * stride;
    const int last = symmetric ? i + 4 : columns;
    for (int j = 0; j < last; j += 2) {
      Lanes tile[4][2];
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 2; ++b) tile[a][b] = sums[(i + a) * columns + j + b];
      }
      for (int d = 0; d < kDerivatives; ++d) {
        const Lanes left = products[d * columns + j], right = products[d * columns + j + 1];
        for (int a = 0; a < 4; ++a) {
          const Lanes function = load_lanes(row + a * stride + d * samples);
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

template <bool kThird>
void contract(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out) {
  constexpr int kDerivatives = kThird ? kThirdOrderCount : kSecondOrderCount;
  const int columns = patch.columns, block = columns * columns;
  Lanes* sums = reinterpret_cast<Lanes*>(scratch);
  Lanes* products = sums + kPairs * block;
  for (int i = 0; i < kPairs * block; ++i) sums[i] = Lanes{};
  for (int s = 0; s < patch.samples; s += kLaneCount) {
    const Jet<Lanes> jet = load_jet<kThird>(patch.jets + s, patch.samples, kThirdOrderCount);
    const JetHessian<kThird, Lanes> hessian(f, jet, load_lanes(patch.weights + s));
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

int patch_hessian_scratch(int columns) {
  return kLaneCount * (kPairs * columns * columns + kThirdOrderCount * columns);
}

void patch_hessian(const HessianPatch& patch, const Weights& weights, double area_factor, double* scratch,
                   double* out) {
  WeightedIntegrand f;
  for (int i = 0; i < kFunctionalCount; ++i) f.weights[i] = weights[i];
  f.area_factor = area_factor;
  patch.third_order ? contract<true>(patch, f, scratch, out) : contract<false>(patch, f, scratch, out);
}

}  // namespace umbilic
