// SPDX-License-Identifier: MIT
/// \file
/// The input of the kernel that computes the second derivatives of a patch's integral.
#pragma once

#include "energy/functional_list.h"

namespace umbilic {

/// f = weight (rho + area_slope) |X_u x X_v|, with rho the weighted sum of densities.
struct WeightedIntegrand {
  double weights[kDensityCount];  ///< of each density
  bool third_order;               ///< whether densities of third order have a weight
  double area_slope;              ///< multiplies the area element
  double umbilic_eta = kUmbilicEta;
};

struct HessianPatch {
  int samples;            ///< a multiple of kSampleMultiple
  int columns;            ///< local points, padded to a multiple of kColumnMultiple with zero basis functions
  const double* weights;  ///< of the samples
  /// [(c * D + d) * samples + s]: derivatives of order 1 to 3 (D = 9), or 1 to 2 (D = 5) if f has no third order.
  const double* jets;
  /// For each coordinate, the basis functions' derivatives of order 1 to 3: [i * stride + d * samples + s] for column
  /// i.
  const double* basis[3];
  int stride;

  static constexpr int kColumnMultiple = 4;
  /// Samples that the kernel processes together: few enough that their data stay in the cache.
  static constexpr int kSamplesAtATime = 32, kThirdOrderSamplesAtATime = 16;
  /// Doubles of scratch memory that the kernel needs: the Hessians of the jets and, per column and sample, the
  /// derivatives of the basis functions and their products with the Hessians.
  static constexpr int scratch(int columns) {
    constexpr int kHessians = 6 * 9 * 9 * kThirdOrderSamplesAtATime;
    constexpr int kRows = 5 * kSamplesAtATime + 8;
    static_assert(kHessians >= 6 * 5 * 5 * kSamplesAtATime && kRows >= 9 * kThirdOrderSamplesAtATime + 8);
    return kHessians + 3 * kRows * columns + 8;
  }
};

}  // namespace umbilic
