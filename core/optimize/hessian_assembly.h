// SPDX-License-Identifier: MIT
/// \file
/// The functional's Hessian and the Sobolev matrix over the optimizer's unknowns, built in parts.
///
/// Hessian = H + u v^T + v u^T with H the patches' second derivatives and u and v the gradients of the area and of the
/// third-order integral.
#pragma once

#include <Eigen/SparseCore>

#include "energy/energy_hessian.h"
#include "optimize/patch_assembly.h"
#include "optimize/sobolev_form.h"
#include "optimize/unknowns.h"

namespace umbilic {

class HessianAssembly {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// `layout` and `unknowns` outlive the assembly; `umbilic_eta` as in EnergyHessian.
  HessianAssembly(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                  const QuadratureRule& rule, double umbilic_eta = kUmbilicEta);

  /// Starts to build the matrices at a surface with these control points.
  void begin(const Points& control);
  /// Does a part of the work, of about the cost of one energy evaluation; returns whether the matrices are ready.
  bool advance();

  /// Fraction of the patches that are done.
  double progress() const;

  /// The lower triangle of hessian_factor * H + sobolev_factor * S.
  Matrix combine(double hessian_factor, double sobolev_factor) const;
  /// (u, v), or no columns where the functional has no third-order part.
  const Eigen::MatrixXd& factors() const { return factors_; }

 private:
  const Unknowns& unknowns_;
  JetEvaluator jets_;
  SurfaceEnergy energy_;  // by the Hessian's own rule, or the scale of the surface would not be free
  PatchAssembly assembly_;
  SobolevForm sobolev_;
  EnergyHessian hessian_;

  enum class Stage { kFactors, kPatches, kReduce, kReady };
  Stage stage_ = Stage::kFactors;
  Points control_;
  PatchCursor cursor_;
  int patches_done_ = 0;
  PatchSums hessian_sums_, sobolev_sums_;
  Matrix reduced_hessian_, reduced_sobolev_;  // where the unknowns are those of a coarser mesh
  Eigen::MatrixXd factors_;
};

}  // namespace umbilic
