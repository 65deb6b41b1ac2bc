// SPDX-License-Identifier: MIT
/// \file
/// This layer's kernels: functions compiled once per instruction set, in the folder kernels/, and called through a
/// table.
#pragma once

#include "energy/functional_list.h"
#include "energy/hessian_patch.h"
#include "energy/invariants.h"
#include "surface/jet_block.h"

namespace umbilic {

/// Integrals of a weighted functional, summed over samples.
struct EnergySums {
  double integrals[kAreaPowerCount];  ///< [p]: weighted integral of the densities whose factor is area^p
  double parametrization;             ///< weighted integral of its density
  double area;
  double gaussian;  ///< integral of the Gaussian curvature
  double smallest;  ///< smallest area element
};

/// The integrals over a block: over the samples in full vectors of lanes, and over those that are left.
struct BlockEnergies {
  EnergySums wide, rest;
};

/// Integrals of each functional and invariant, summed over samples; without their powers of the area.
struct FunctionalSums {
  double functionals[kFunctionalCount];
  double invariants[kInvariantCount];  ///< of II = n . X_ij
  double parametrization;              ///< integral of its density
  double area;
  double gaussian;
};

struct EnergyKernels {
  /// The block's integrals of the densities of these powers of the area; the parametrization's counts as one of power
  /// 0. `weights` are those of the kDensityCount densities. If the block has adjoints, overwrites them with those of
  /// the integral of each power, in rising order, and of the area if there is a functional of third order.
  BlockEnergies (*integrate)(const double* weights, const AreaPowers& powers, const JetBlock& block);
  /// Writes the second derivatives of the patch's integral by coordinate c of point i and e of point j to out[(c *
  /// columns + i) * (3 * columns) + (e * columns + j)], for e <= c. If e == c only the entries with j <= i are
  /// meaningful.
  void (*patch_hessian)(const HessianPatch& patch, const WeightedIntegrand& f, double* scratch, double* out);
  /// The block's integrals of all functionals and invariants; its jets must have third order.
  FunctionalSums (*integrate_all)(const JetBlock& block);
};

/// The kernels of the instruction set in use.
const EnergyKernels& energy_kernels();

}  // namespace umbilic
