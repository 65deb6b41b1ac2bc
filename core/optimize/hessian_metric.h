// SPDX-License-Identifier: MIT
/// \file
/// The functional's Hessian, made positive definite by a multiple of the Sobolev product, as the optimizer's metric.
#pragma once

#include <Eigen/SparseCholesky>

#include "optimize/hessian_assembly.h"
#include "optimize/surface_metric.h"

namespace umbilic {

/// metric = H + u v^T + v u^T + mu S, the rank-two term by Woodbury's formula. mu rises until the sum is positive
/// definite, and falls again from one surface to the next.
class HessianMetric : public SurfaceMetric {
 public:
  /// `layout` and `unknowns` outlive the metric.
  HessianMetric(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                const QuadratureRule& rule);

  void begin(const Points& control) override;
  bool advance() override;
  std::string_view name() const override { return "hessian"; }
  bool knows_hessian() const override { return true; }
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override;
  /// Whether mu fell no further.
  bool settled() const override { return settled_; }
  /// mu.
  double sobolev_share() const override { return mu_; }

 private:
  bool factor();

  HessianAssembly assembly_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
  bool assembled_ = false, ready_ = false, analyzed_ = false, settled_ = false;
  double mu_;
  Eigen::MatrixXd solved_;  ///< metric without the rank-two term, applied inversely to (u, v)
  Eigen::Matrix2d core_;    ///< of Woodbury's formula
};

}  // namespace umbilic
