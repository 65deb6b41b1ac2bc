// SPDX-License-Identifier: MIT
/// \file
/// Second derivatives of a surface's weighted functional, patch by patch.
///
/// With the energy second + area * third, the patches' matrices sum to D^2 second + area D^2 third + third D^2 area;
/// what is missing of the Hessian is the rank-two term grad area grad third^T + grad third grad area^T. Of `flat` caps
/// n is frozen. Near umbilics, where second derivatives grow like the inverse square of the distance and hold over no
/// more than that distance, they may be those of a more regularized density.
#pragma once

#include <vector>

#include "energy/hessian_patch.h"
#include "energy/surface_energy.h"
#include "surface/patch_evaluator.h"

namespace umbilic {

class EnergyHessian {
 public:
  /// `layout` outlives the Hessian.
  EnergyHessian(const PatchLayout& layout, const QuadratureRule& rule, const Weights& weights,
                double umbilic_eta = kUmbilicEta);

  /// Where the derivatives are taken. `value` is the energy there.
  void move_to(const Points& control, const EnergyValue& value);

  /// The matrix of a patch (of one that it stands for): row-major, 3 columns(set) x 3 columns(set), as
  /// EnergyKernels::patch_hessian leaves it. Valid until the next call.
  const double* patch(int set, int patch);
  int columns(int set) const { return patches_.basis(set).table().padded_columns; }
  int samples(int set) const { return patches_.basis(set).table().samples; }

 private:
  PatchEvaluator patches_;
  Weights weights_;
  WeightedIntegrand integrand_{};
  Eigen::Matrix<double, Eigen::Dynamic, 3> turned_;  // jets of a flat cap, the normal as third axis
  std::vector<double> scratch_, block_;
};

}  // namespace umbilic
