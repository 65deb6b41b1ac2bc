// SPDX-License-Identifier: MIT
/// \file
/// Sparse products between the coordinates of two meshes.
#include "optimize/unknowns.h"

#include <vector>

namespace umbilic {

Eigen::SparseMatrix<double> Unknowns::reduce(const Eigen::SparseMatrix<double>& lower) const {
  const Eigen::SparseMatrix<double> full = lower.selfadjointView<Eigen::Lower>();
  const Eigen::SparseMatrix<double> half = full * map_;
  const Eigen::SparseMatrix<double> reduced = map_.transpose() * half;
  return reduced.triangularView<Eigen::Lower>();
}

/// The stencil applied to x, y and z of each point.
Eigen::SparseMatrix<double> Unknowns::stencil_of_coordinates(const Eigen::SparseMatrix<double>& stencil) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < stencil.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(stencil, column); it; ++it) {
      for (int c = 0; c < 3; ++c)
        entries.emplace_back(static_cast<int>(3 * it.row() + c), static_cast<int>(3 * it.col() + c), it.value());
    }
  }
  Eigen::SparseMatrix<double> result(3 * stencil.rows(), 3 * stencil.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace umbilic
