// SPDX-License-Identifier: MIT
/// \file
/// The Sobolev inner product of a surface, patch by patch: one scalar matrix for x, y and z.
///
/// A_ij = integral of w2 2 (grad^2 phi_i : grad^2 phi_j) + w3 2 area (grad^3 phi_i : grad^3 phi_j) + mass over the
/// surface, with covariant derivatives. w2 and w3 are the weights of the functional's parts of second and third order.
/// The mass term 0.01 (10 / sqrt(area))^(2k) phi_i phi_j removes the kernel (metric_rules.h). For `flat` caps only the
/// normal part is taken, with n fixed.
#pragma once

#include "base/aligned_doubles.h"
#include "energy/functional.h"
#include "surface/patch_evaluator.h"

namespace umbilic {

/// What the form writes while it computes the matrix of a patch: one for each thread that does.
struct SobolevMemory {
  PatchMemory patches;
  AlignedDoubles scratch;
};

class SobolevForm {
 public:
  /// `layout` must outlive the form.
  SobolevForm(const PatchLayout& layout, const Weights& weights);

  /// Chooses the surface. `area` is its area.
  void move_to(const Points& control, double area);

  /// The lower triangle of the matrix over the local points of a patch of the layout. Threads with different memory may
  /// call at the same time.
  Eigen::MatrixXd patch(int set, int patch, SobolevMemory& memory) const;
  int samples(int set) const { return patches_.basis(set).table().distinct; }

 private:
  PatchEvaluator patches_;
  double second_, third_;
  double area_ = 1;
};

}  // namespace umbilic
