// SPDX-License-Identifier: MIT
/// \file
/// The functional's Hessian, made positive definite by a multiple of the Sobolev product, as the optimizer's metric.
///
/// metric = H + u v^T + v u^T + mu S with H the patches' second derivatives, u and v the gradients of the area and of
/// the third-order integral (the product's rank-two term, by Woodbury's formula), S the Sobolev matrix. mu rises until
/// the sum is positive definite, and falls again from one surface to the next.
#pragma once

#include <Eigen/SparseCholesky>

#include "energy/energy_hessian.h"
#include "optimize/patch_assembly.h"
#include "optimize/sobolev_form.h"
#include "optimize/surface_metric.h"

namespace umbilic {

class HessianMetric : public SurfaceMetric {
 public:
  /// `energy` and `coordinates` outlive the metric.
  HessianMetric(const SurfaceEnergy& energy, const Coordinates& coordinates, const QuadratureRule& rule);

  void begin(const Points& control) override;
  bool advance() override;
  std::string_view name() const override { return "hessian"; }
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override;

  /// Of the metric in use.
  double mu() const { return mu_; }

 private:
  enum class Stage { kFactors, kPatches, kFactor, kReady };

  bool factor();

  const SurfaceEnergy& energy_;
  const Coordinates& coordinates_;
  PatchAssembly assembly_;
  SobolevForm sobolev_;
  EnergyHessian hessian_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
  bool analyzed_ = false;

  Stage stage_ = Stage::kFactors;
  Points control_;
  PatchCursor cursor_;
  std::vector<double> hessian_values_, sobolev_values_;
  double mu_;
  int attempts_ = 0;

  Eigen::MatrixXd factors_, solved_;  ///< (u, v) and the solutions for them
  Eigen::Matrix2d core_;                                       ///< of Woodbury's formula
};

}  // namespace umbilic
