// SPDX-License-Identifier: MIT
/// \file
/// The second derivatives of one patch's integral by its local points: Wᵀ D W, with D the jets' Hessians and W the
/// basis.
#pragma once

#include "energy/functional.h"

namespace umbilic {

/// A patch as the kernel wants it. Derivatives d are those of order 1 to 3 (5 of them without third order).
struct HessianPatch {
  int samples;            ///< a multiple of kLaneCount
  int columns;            ///< local points, a multiple of 4: surplus ones have zero basis functions
  bool third_order;       ///< whether densities of third order have a weight
  const double* weights;  ///< of the samples
  const double* jets;     ///< [(c * derivatives + d) * samples + s], derivatives = 9
  /// Of each coordinate: the basis functions' derivatives, [i * stride + d * samples + s] for column i.
  const double* basis[3];
  int stride;
};

/// Doubles of scratch memory that `patch_hessian` wants.
int patch_hessian_scratch(int columns);

/// Overwrites out[(c * columns + i) * (3 * columns) + (e * columns + j)] for e <= c (and for c == e only j <= i is
/// meaningful) with the second derivative by coordinate c of point i and coordinate e of point j.
/// `weights` are those of the densities, `area_factor` that of the area.
void patch_hessian(const HessianPatch& patch, const Weights& weights, double area_factor, double* scratch, double* out);

}  // namespace umbilic
