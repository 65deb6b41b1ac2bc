// SPDX-License-Identifier: MIT
/// \file
/// The Sobolev inner product of a surface as the optimizer's metric.
#pragma once

#include <memory>
#include <vector>

#include "optimize/closeness_term.h"
#include "optimize/gauge.h"
#include "optimize/patch_assembly.h"
#include "optimize/sobolev_form.h"
#include "optimize/surface_metric.h"
#include "optimize/unknowns.h"
#include "solve/sparse_cholesky.h"
#include "solve/tangent_projection.h"

namespace umbilic {

/// Assembles the matrix, some patches at a time, and factors it. If each vertex has its own x, y and z as unknowns, one
/// scalar matrix serves all three. If the gauge contains scaling, directions are projected so that they keep the moment
/// of the control points about their centroid: unlike the energy, the product is not invariant under scaling, and
/// surfaces would grow from step to step. The second derivatives of `closeness`, if given, are added to the product.
class SobolevMetric : public SurfaceMetric {
 public:
  /// `energy` and `unknowns` must outlive the metric.
  SobolevMetric(const SurfaceEnergy& energy, const Unknowns& unknowns, const Gauge& gauge = {},
                const ClosenessTerm* closeness = nullptr);

  void begin(const Points& control, double parametrization = 0) override;
  bool advance() override;
  bool knows_hessian() const override { return false; }
  bool settled() const override { return true; }
  void settle() override {}
  void gained(double) override {}
  int factorizations() const override { return factorizations_; }
  double sobolev_share() const override { return 1; }
  Eigen::VectorXd solve(const Eigen::VectorXd& gradient) const override;

 private:
  Eigen::VectorXd solve_freely(const Eigen::VectorXd& gradient) const;

  /// What a thread writes while it computes the matrix of a patch.
  struct Memory {
    SobolevMemory sobolev;
    PatchMemory closeness;
  };
  /// What a patch adds to the sums.
  struct Terms {
    PatchTerms sobolev, closeness;
  };
  void add_patches();

  enum class Stage { kArea, kPatches, kSum, kFactor, kReady };

  const SurfaceEnergy& energy_;
  const Unknowns& unknowns_;
  const ClosenessTerm* closeness_;
  bool scalar_, scaling_;
  PatchAssembly assembly_;
  SobolevForm form_;
  SparseCholesky factor_{SparseCholesky::Pivots::kPositive};
  int factorizations_ = 0;

  Stage stage_ = Stage::kArea;
  Points control_;
  PatchCursor cursor_;
  std::vector<Memory> memories_;  // of each thread
  std::vector<Terms> terms_;      // in each slot
  PatchSums sums_;
  TangentProjection fixed_size_;
};

}  // namespace umbilic
