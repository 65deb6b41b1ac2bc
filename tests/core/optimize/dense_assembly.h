// SPDX-License-Identifier: MIT
/// \file
/// Sums of patches' matrices without sparsity, orbits or elimination, for comparison with PatchAssembly.
#pragma once

#include <vector>

#include "linear_algebra.h"
#include "surface/layout.h"

namespace umbilic::test {

inline Eigen::MatrixXd full(const Eigen::SparseMatrix<double>& lower) {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

/// The control points' part in a patch's points, columns(set) x control_count.
inline Eigen::MatrixXd local_points(const PatchLayout& layout, int set, int patch) {
  const PatchSet& patches = layout.sets()[set];
  const Eigen::MatrixXd extension(layout.extension());
  Eigen::MatrixXd rows(patches.columns, layout.control_count());
  for (int i = 0; i < patches.columns; ++i) rows.row(i) = extension.row(patches.points[patches.columns * patch + i]);
  return rows;
}

/// Calls visit(set, patch) for each patch.
template <class Visit>
void for_each_patch(const PatchLayout& layout, const Visit& visit) {
  for (int s = 0; s < static_cast<int>(layout.sets().size()); ++s) {
    for (int p = 0; p < layout.sets()[s].count(); ++p) visit(s, p);
  }
}

/// Symmetric, over the points' coordinates c * columns + i, to the coordinates 3 v + c of the control points.
inline Eigen::MatrixXd over_control(const Eigen::MatrixXd& block, const Eigen::MatrixXd& local) {
  const Eigen::Index columns = local.rows(), count = local.cols();
  Eigen::MatrixXd result(3 * count, 3 * count);
  for (int c = 0; c < 3; ++c) {
    for (int e = 0; e < 3; ++e) {
      const Eigen::MatrixXd part = congruent(block.block(c * columns, e * columns, columns, columns), local);
      for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j) result(3 * i + c, 3 * j + e) = part(i, j);
      }
    }
  }
  return result;
}

}  // namespace umbilic::test
