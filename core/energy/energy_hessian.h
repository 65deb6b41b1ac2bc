// SPDX-License-Identifier: MIT
/// \file
/// Second derivatives of a surface's weighted functional, patch by patch.
///
/// The energy is E = sum of area^p I_p, with I_p the weighted integral of the densities whose factor is area^p. The
/// patches' matrices sum to the sum of area^p D^2 I_p, plus dE/darea D^2 area. The full Hessian has in addition a term
/// of rank two, see SurfaceEnergy::evaluate_factors. The normals of `flat` caps are held fixed. Near umbilics second
/// derivatives grow like the inverse square of the distance and describe the energy only within that distance, so the
/// caller may ask for those of a more strongly regularized density.
#pragma once

#include <vector>

#include "energy/hessian_patch.h"
#include "energy/surface_energy.h"
#include "surface/patch_evaluator.h"

namespace umbilic {

/// What the Hessian writes while it computes the matrix of a patch: one for each thread that does.
struct HessianMemory {
  PatchMemory patches;
  Eigen::Matrix<double, Eigen::Dynamic, 3>
      turned;  ///< jets of a flat cap, rotated so that the normal is the third axis
  std::vector<double> scratch;
};

class EnergyHessian {
 public:
  /// `layout` must outlive the Hessian.
  EnergyHessian(const PatchLayout& layout, const QuadratureRule& rule, const Weights& weights,
                double umbilic_eta = kUmbilicEta);

  /// Chooses the surface. `value` is its energy, `parametrization` the weight of the parametrization's density.
  void move_to(const Points& control, const EnergyValue& value, double parametrization = 0);

  /// The matrix of a patch of the layout: row-major, 3 columns(set) x 3 columns(set), as EnergyKernels::patch_hessian
  /// leaves it. `block` grows as needed. Threads with different memory may call at the same time.
  void patch(int set, int patch, HessianMemory& memory, std::vector<double>& block) const;
  int columns(int set) const { return patches_.basis(set).table().padded_columns; }
  int samples(int set) const { return patches_.basis(set).table().samples; }

 private:
  PatchEvaluator patches_;
  Weights weights_;
  WeightedIntegrand integrand_{};
};

}  // namespace umbilic
