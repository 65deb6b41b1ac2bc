// SPDX-License-Identifier: MIT
/// \file
/// One patch, as the kernel that differentiates its integral twice wants it.
#pragma once

#include "energy/functional_list.h"

namespace umbilic {

/// f = weight (rho |X_u x X_v| + area_factor |X_u x X_v|) with rho the weighted sum of densities.
struct WeightedIntegrand {
  double weights[kFunctionalCount];  ///< of the densities
  bool third_order;                  ///< whether densities of third order have a weight
  double area_factor;                ///< of the area element alone
  double umbilic_eta = kUmbilicEta;
};

struct HessianPatch {
  int samples;            ///< a multiple of kSampleMultiple
  int columns;            ///< local points, a multiple of kColumnMultiple: surplus ones have zero basis functions
  const double* weights;  ///< of the samples
  /// [(c * D + d) * samples + s], of order 1 to 3 (D = 9) or 2 (D = 5), as f depends on them.
  const double* jets;
  /// Of each coordinate: the basis functions' derivatives of order 1 to 3, [i * stride + d * samples + s] for column i.
  const double* basis[3];
  int stride;

  static constexpr int kColumnMultiple = 4;
  /// Samples whose contributions the kernel adds up in registers: few enough that they stay in the cache.
  static constexpr int kSamplesAtATime = 32, kThirdOrderSamplesAtATime = 16;
  /// Doubles of scratch memory that the kernel wants: the jets' Hessians, and per column and sample the basis
  /// functions' derivatives of two kinds and what the Hessians make of them.
  static constexpr int scratch(int columns) {
    constexpr int kHessians = 6 * 9 * 9 * kThirdOrderSamplesAtATime;
    constexpr int kRows = 5 * kSamplesAtATime + 8;
    static_assert(kHessians >= 6 * 5 * 5 * kSamplesAtATime && kRows >= 9 * kThirdOrderSamplesAtATime + 8);
    return kHessians + 3 * kRows * columns + 8;
  }
};

}  // namespace umbilic
