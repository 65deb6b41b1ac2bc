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
  const double* jets;     ///< [(c * 9 + d) * samples + s]
  /// Of each coordinate: the basis functions' derivatives of order 1 to 3, [i * stride + d * samples + s] for column i.
  const double* basis[3];
  int stride;

  static constexpr int kColumnMultiple = 4;
  /// Doubles of scratch memory that the kernel wants.
  static constexpr int scratch(int columns) { return 4 * (6 * columns * columns + 9 * columns + 1); }
};

}  // namespace umbilic
