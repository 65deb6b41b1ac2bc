// SPDX-License-Identifier: MIT
/// \file
/// The Hessian of the functional and the Sobolev matrix over the optimizer's unknowns, assembled in parts.
///
/// Hessian = H + u v^T + v u^T. H sums the second derivatives of the patches; u and v are the factors of
/// SurfaceEnergy::evaluate_factors, u the gradient of the area. There are none if the energy has no power of the area
/// as a factor, or a constant in its place.
#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "energy/energy_hessian.h"
#include "optimize/closeness_term.h"
#include "optimize/patch_assembly.h"
#include "optimize/sobolev_form.h"
#include "optimize/unknowns.h"

namespace umbilic {

class HessianAssembly {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// `layout` and `unknowns` must outlive the assembly; `umbilic_eta` as in EnergyHessian,
  /// `fixed_area` as in SurfaceEnergy. The second derivatives of `closeness`, if given, are added to H.
  HessianAssembly(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                  const QuadratureRule& rule, double umbilic_eta = kUmbilicEta, std::optional<double> fixed_area = {},
                  const ClosenessTerm* closeness = nullptr);

  /// Begins to assemble the matrices at a surface with these control points. `parametrization` is the weight of its
  /// density (energy/densities.h).
  void begin(const Points& control, double parametrization = 0);
  /// Does about as much work as one energy evaluation, shared among threads. Returns whether the matrices are ready.
  bool advance();

  /// Fraction of the patches done.
  double progress() const;

  /// The lower triangle of hessian_factor * H + sobolev_factor * S.
  Matrix combine(double hessian_factor, double sobolev_factor) const;
  /// The columns u and v; none if the energy has no product with the area.
  const Eigen::MatrixXd& factors() const { return factors_; }

 private:
  /// What a thread writes while it computes the matrices of a patch.
  struct Memory {
    HessianMemory hessian;
    SobolevMemory sobolev;
    std::vector<double> block;
  };
  /// What a patch adds to both sums.
  struct Terms {
    PatchTerms hessian, sobolev;
  };
  void add_patches();

  const Unknowns& unknowns_;
  JetEvaluator jets_;
  SurfaceEnergy energy_;  // with the Hessian's quadrature rule, so that scaling stays in its kernel
  PatchAssembly assembly_;
  SobolevForm sobolev_;
  EnergyHessian hessian_;

  enum class Stage { kFactors, kPatches, kReduce, kReady };
  Stage stage_ = Stage::kFactors;
  Points control_;
  double parametrization_ = 0;
  PatchCursor cursor_;
  int patches_done_ = 0;
  std::vector<Memory> memories_;  // of each thread
  std::vector<Terms> terms_;      // in each slot
  const ClosenessTerm* closeness_;
  PatchSums hessian_sums_, sobolev_sums_, closeness_sums_;  // the last are constant
  Matrix reduced_hessian_, reduced_sobolev_;                // used if the unknowns are those of a coarser mesh
  Eigen::MatrixXd factors_;
};

}  // namespace umbilic
