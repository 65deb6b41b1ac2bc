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

/// How the coordinates of all points, d * point + c, depend on unknowns. `control` is that of the d coordinates of the
/// control points.
inline Eigen::MatrixXd all_points(const PatchLayout& layout, int d, const Eigen::MatrixXd& control) {
  const Eigen::SparseMatrix<double> extension(layout.extension());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(d * extension.rows(), control.cols());
  for (int k = 0; k < extension.outerSize(); ++k) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(extension, k); it; ++it) {
      for (int c = 0; c < d; ++c) all.row(d * it.row() + c) += it.value() * control.row(d * it.col() + c);
    }
  }
  return all;
}

/// The rows of all_points that a patch reads, coordinate c of its i-th point at c * columns + i.
inline Eigen::MatrixXd patch_points(const PatchLayout& layout, int d, const Eigen::MatrixXd& all, int set, int patch) {
  const PatchSet& patches = layout.sets()[set];
  const int columns = patches.columns;
  Eigen::MatrixXd rows(d * columns, all.cols());
  for (int i = 0; i < columns; ++i) {
    for (int c = 0; c < d; ++c) rows.row(c * columns + i) = all.row(d * patches.points[columns * patch + i] + c);
  }
  return rows;
}

/// Calls visit(set, patch) for each patch.
template <class Visit>
void for_each_patch(const PatchLayout& layout, const Visit& visit) {
  for (int s = 0; s < static_cast<int>(layout.sets().size()); ++s) {
    for (int p = 0; p < layout.sets()[s].count(); ++p) visit(s, p);
  }
}

}  // namespace umbilic::test
