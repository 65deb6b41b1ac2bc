// SPDX-License-Identifier: MIT
/// \file
/// The Sobolev inner product of a surface, patch by patch: one scalar matrix for x, y and z.
///
/// A_ij = w2 2 (grad^2 phi_i : grad^2 phi_j) + w3 2 area (grad^3 phi_i : grad^3 phi_j) + mass, integrated over the
/// surface with covariant derivatives; w2, w3 weigh the functional's parts of second and third order. The mass term
/// 0.01 (10 / sqrt(area))^(2k) phi_i phi_j removes the kernel. Of `flat` caps the normal part is taken, with n frozen.
#pragma once

#include <vector>

#include "energy/functional.h"
#include "surface/basis_table.h"
#include "surface/flat_frame.h"

namespace umbilic {

class SobolevForm {
 public:
  /// `layout` outlives the form.
  SobolevForm(const PatchLayout& layout, const Weights& weights);

  /// The surface whose inner product it is, of this area.
  void move_to(const Points& control, double area);

  /// The lower triangle of the matrix over the local points of a patch (of one that it stands for).
  Eigen::MatrixXd patch(int set, int patch) const;
  int samples(int set) const { return kinds_[set].table->samples; }

 private:
  struct Kind {
    std::shared_ptr<const BasisTable> table;
    Eigen::MatrixXd normal_part;  ///< of `flat` caps: basis - flattening; else empty

    /// The basis whose products are taken.
    const Eigen::MatrixXd& functions() const { return normal_part.size() > 0 ? normal_part : table->basis; }
  };

  Eigen::Matrix<double, Eigen::Dynamic, 3> jets(int set, int patch) const;

  const PatchLayout& layout_;
  double second_, third_;
  std::vector<Kind> kinds_;
  Points points_;
  std::vector<FlatFrame> frames_;
  double area_ = 1;
};

}  // namespace umbilic
