// SPDX-License-Identifier: MIT
/// \file
/// The Sobolev inner product of a surface, patch by patch: one scalar matrix for x, y and z.
///
/// A_ij = w2 2 (grad^2 phi_i : grad^2 phi_j) + w3 2 area (grad^3 phi_i : grad^3 phi_j) + mass, integrated over the
/// surface with covariant derivatives; w2, w3 weigh the functional's parts of second and third order. The mass term
/// 0.01 (10 / sqrt(area))^(2k) phi_i phi_j removes the kernel (metric_rules.h). Of `flat` caps the normal part is
/// taken, with n frozen.
#pragma once

#include "energy/functional.h"
#include "surface/patch_evaluator.h"

namespace umbilic {

class SobolevForm {
 public:
  /// `layout` outlives the form.
  SobolevForm(const PatchLayout& layout, const Weights& weights);

  /// The surface whose inner product it is, of this area.
  void move_to(const Points& control, double area);

  /// The lower triangle of the matrix over the local points of a patch (of one that it stands for).
  Eigen::MatrixXd patch(int set, int patch);
  int samples(int set) const { return patches_.basis(set).table().distinct; }

 private:
  PatchEvaluator patches_;
  double second_, third_;
  double area_ = 1;
};

}  // namespace umbilic
