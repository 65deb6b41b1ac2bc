// SPDX-License-Identifier: MIT
/// \file
/// A quadratic term that pulls a surface to another one: the integral of |X - X0|^2 dA over the patches of a layout,
/// between points of the same parameters, with the area element dA of X0.
///
/// With P - P0 the displacement of the control points, it is the sum over x, y and z of (P - P0)^T M (P - P0), where M
/// is the mass matrix of the layout's basis functions.
#pragma once

#include <Eigen/SparseCore>

#include "surface/patch_evaluator.h"

namespace umbilic {

class ClosenessTerm {
 public:
  /// X0 is the layout's surface with the control points `own`; `layout` must outlive the term.
  ClosenessTerm(const PatchLayout& layout, const Points& own, double weight);

  double weight() const { return weight_; }
  /// weight times the integral; adds its gradient to that of the energy, if given.
  double evaluate(const Points& control, Points* gradient) const;
  /// The second derivatives of the weighted integral by the points of a patch, the same for x, y and z: columns x
  /// columns. Threads with different memory may call at the same time.
  Eigen::MatrixXd patch(int set, int patch, PatchMemory& memory) const;

 private:
  PatchEvaluator patches_;
  Points own_;
  double weight_;
  Eigen::SparseMatrix<double> mass_;  // the lower triangle of M
};

}  // namespace umbilic
