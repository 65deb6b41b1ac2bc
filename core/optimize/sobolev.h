// SPDX-License-Identifier: MIT
/// \file
/// The Sobolev inner product of a surface as the optimizer's metric, one sparse scalar matrix for x, y and z.
///
/// A_ij = w2 2 (grad^2 phi_i : grad^2 phi_j) + w3 2 area (grad^3 phi_i : grad^3 phi_j) + mass, integrated over the
/// surface with covariant derivatives; w2, w3 weigh the functional's parts of second and third order. The mass term
/// 0.01 (10 / sqrt(area))^(2k) phi_i phi_j removes the kernel. Of `flat` caps the normal part is taken, with n frozen.
#pragma once

#include <Eigen/SparseCholesky>
#include <memory>

#include "energy/functional.h"
#include "optimize/objective.h"
#include "surface/layout.h"

namespace umbilic {

/// Assembles the matrix at a surface, some patches at a time, and factors it.
class SobolevMetric : public Metric {
 public:
  /// `layout` outlives the metric.
  SobolevMetric(const PatchLayout& layout, const Weights& weights, Points control);
  ~SobolevMetric() override;

  /// Does a part of the work, of about the cost of one energy evaluation; returns whether the metric is ready.
  bool advance();

  /// Unknowns are the control points' coordinates, point by point. `advance` has returned true.
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override;

  std::size_t factor_nonzeros() const;

 private:
  struct Assembly;
  std::unique_ptr<Assembly> assembly_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
};

}  // namespace umbilic
