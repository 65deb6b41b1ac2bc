// SPDX-License-Identifier: MIT
/// \file
/// The functional's Hessian, made positive definite by a multiple of the Sobolev product, as the optimizer's metric.
#pragma once

#include "optimize/hessian_assembly.h"
#include "optimize/surface_metric.h"
#include "solve/sparse_cholesky.h"
#include "solve/tangent_projection.h"

namespace umbilic {

/// metric = H + u v^T + v u^T + mu S on the directions d that keep the surface's size, a . d = 0.
///
/// The scale is free (optimize/gauge.h): energies have degree 0 in the control points x, so that x . Hessian x = 0 and
/// Hessian x = -gradient. Newton's step would be a mere change of scale, and the Hessian indefinite wherever the
/// gradient is not 0. With a = u, the gradient of the area, the rank-two term vanishes, and H + mu S is all that is to
/// be factored; without a third-order part a is the direction of scaling itself. mu rises until the factorization
/// succeeds, and falls from one surface to the next, the faster the longer it needed no rise.
class HessianMetric : public SurfaceMetric {
 public:
  /// `layout` and `unknowns` outlive the metric.
  HessianMetric(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights,
                const QuadratureRule& rule);

  void begin(const Points& control) override;
  bool advance() override;
  bool knows_hessian() const override { return true; }
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override;
  /// Whether mu is small, or fell no further.
  bool settled() const override { return settled_; }
  void settle() override;
  /// Whether mu hides no more than a part of the Hessian.
  bool predicts() const override;
  /// mu.
  double sobolev_share() const override { return mu_; }
  /// a.
  const Eigen::VectorXd& size_gradient() const { return size_gradient_; }

 private:
  void end_factoring();

  const Unknowns& unknowns_;
  HessianAssembly assembly_;
  SparseCholesky factor_{SparseCholesky::Pivots::kPositive};
  bool assembled_ = false, factoring_ = false, ready_ = false, settled_ = false, rose_ = false;
  double mu_, fall_ = 1;
  Eigen::VectorXd size_gradient_;  ///< a
  TangentProjection fixed_size_;
};

}  // namespace umbilic
