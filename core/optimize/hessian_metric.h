// SPDX-License-Identifier: MIT
/// \file
/// The optimizer's metric made of the Hessian of the functional and enough of the Sobolev product to be positive
/// definite.
#pragma once

#include "optimize/gauge.h"
#include "optimize/hessian_assembly.h"
#include "optimize/surface_metric.h"
#include "solve/absolute_inverse.h"
#include "solve/sparse_cholesky.h"
#include "solve/tangent_projection.h"

namespace umbilic {

/// metric = H + u v^T + v u^T + mu S, restricted to the directions d that keep the surface's size, a . d = 0, if the
/// gauge contains scaling.
///
/// Why the size is then kept: energies have degree 0 in the control points x (optimize/gauge.h), so x . Hessian x = 0
/// and Hessian x = -gradient. Without the restriction Newton's step would only change the scale, and the Hessian would
/// be indefinite wherever the gradient is not 0.
///
/// Which a: with a third-order part, a = u, the gradient of the area. On a . d = 0 the rank-two term then vanishes, and
/// only H + mu S must be factored. Without one, a is the direction of scaling itself.
///
/// Which mu: it grows until the factorization succeeds, and shrinks from one surface to the next, faster the longer it
/// has not had to grow.
///
/// Newton's metric replaces up to kMostNegative negative eigenvalues by their absolute values instead
/// (solve/absolute_inverse.h), so that mu need not be as large as the most negative one. A few such eigenvalues are
/// usual: without symmetry a surface has many soft directions, those of its parametrization above all, and mu would
/// damp them all. Where the search for them misses one, the metric may fail to be positive definite; that is mended by
/// a larger mu if the optimizer finds no way down. mu then measures how far the Hessian is trusted, by the latest
/// decreases, as in a trust region.
class HessianMetric : public SurfaceMetric {
 public:
  /// `layout` and `unknowns` must outlive the metric; `fixed_area` as in SurfaceEnergy, `closeness` as in
  /// HessianAssembly.
  HessianMetric(const PatchLayout& layout, const Unknowns& unknowns, const Weights& weights, const QuadratureRule& rule,
                const Gauge& gauge = {}, std::optional<double> fixed_area = {},
                const ClosenessTerm* closeness = nullptr, bool newton = false);

  void begin(const Points& control, double parametrization = 0) override;
  bool advance() override;
  bool knows_hessian() const override { return true; }
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override;
  /// Whether mu is small, or had to grow.
  bool settled() const override { return settled_; }
  void settle() override;
  bool positive() const override;
  void make_positive() override;
  /// Whether mu is small enough that the Hessian, not the Sobolev product, dominates the metric.
  bool predicts() const override;
  void gained(double part) override { latest_gain_ = part; }
  int factorizations() const override { return factorizations_; }
  /// mu.
  double sobolev_share() const override { return mu_; }
  /// a.
  const Eigen::VectorXd& size_gradient() const { return size_gradient_; }

 private:
  void end_factoring();
  bool replace_negative();
  Eigen::VectorXd solve_freely(const Eigen::VectorXd& gradient) const { return absolute_.solve(factor_, gradient); }

  const Unknowns& unknowns_;
  bool newton_;
  bool scaling_;  // whether the gauge contains it
  HessianAssembly assembly_;
  SparseCholesky factor_;
  AbsoluteInverse absolute_;
  double latest_gain_ = 1;
  int factorizations_ = 0;
  bool assembled_ = false, positive_ = false, must_be_positive_ = false, factoring_ = false, ready_ = false,
       settled_ = false, rose_ = false;
  double mu_, fall_ = 1;
  Eigen::VectorXd size_gradient_;  ///< a
  TangentProjection fixed_size_;
};

}  // namespace umbilic
