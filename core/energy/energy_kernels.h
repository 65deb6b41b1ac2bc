// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels: what is compiled once per instruction set, from the folder kernels/, and called through a
/// table.
#pragma once

#include "energy/functional_list.h"
#include "energy/hessian_patch.h"
#include "surface/jet_block.h"

namespace umbilic {

/// Of a weighted functional, over samples.
struct EnergySums {
  double second, third;  ///< weighted integrals of the densities of either order
  double area;
  double gaussian;  ///< integral of the Gaussian curvature
  double smallest;  ///< least area element
};

/// Of every functional, over samples; third-order ones without the factor area.
struct FunctionalSums {
  double functionals[kFunctionalCount];
  double area;
  double gaussian;
};

struct EnergyKernels {
  /// Adds the block's integrals, by the densities of second order, of third or both. Overwrites, where the block has
  /// them, the adjoints of the second-order integral (with `second_order`), of the third-order one and of the area
  /// (with `third_order`), in this order. `weights` of the functionals.
  void (*integrate)(const double* weights, bool second_order, bool third_order, const JetBlock& block,
                    EnergySums& sums);
  /// Overwrites out[(c * columns + i) * (3 * columns) + (e * columns + j)] for e <= c (where c == e only j <= i is
  /// meaningful) with the second derivative of the patch's integral by coordinate c of point i and e of point j.
  void (*patch_hessian)(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out);
  /// Adds the block's integrals; its jets reach to third order.
  void (*integrate_all)(const JetBlock& block, FunctionalSums& sums);
};

/// For the instruction set in use.
const EnergyKernels& energy_kernels();

}  // namespace umbilic
