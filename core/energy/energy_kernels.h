// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels: what is compiled once per instruction set, from the folder kernels/, and called through a
/// table.
#pragma once

#include "energy/functional_list.h"
#include "surface/jet_block.h"

namespace umbilic {

/// Of a weighted functional, over samples.
struct EnergySums {
  double second, third;  ///< weighted integrals of the densities of either order
  double area;
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
  /// Adds the block's integrals; its jets reach to third order.
  void (*integrate_all)(const JetBlock& block, FunctionalSums& sums);
};

/// For the instruction set in use.
const EnergyKernels& energy_kernels();

}  // namespace umbilic
