// SPDX-License-Identifier: MIT
/// \file
/// Richardson's iteration, which keeps every symmetry of the cage and the targets.
#include "cage/limit_fit.h"

namespace umbilic {

void fit_limit(Cage& cage, const std::vector<int>& free, const Points& targets) {
  constexpr int kIterations = 200;  // (5/6)^200 < 2e-16
  constexpr double kStep = 1.5;     // the limit's symbol is between 1/9 and 1
  const Eigen::Index count = cage.vertices.rows();
  Eigen::VectorXd valence = Eigen::VectorXd::Zero(count);
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) valence[v] += 1;
  }
  Points sums(count, 3);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    // Each face gives half of its two edge neighbours, which another face gives as well.
    sums.setZero();
    for (const std::vector<int>& face : cage.faces) {
      for (int i = 0; i < 4; ++i) {
        sums.row(face[i]) += 2 * (cage.vertices.row(face[(i + 1) % 4]) + cage.vertices.row(face[(i + 3) % 4])) +
                             cage.vertices.row(face[(i + 2) % 4]);
      }
    }
    for (const int v : free) {
      const double n = valence[v];
      const Eigen::RowVector3d limit = (n * n * cage.vertices.row(v) + sums.row(v)) / (n * (n + 5));
      sums.row(v) = kStep * (targets.row(v) - limit);
    }
    for (const int v : free) cage.vertices.row(v) += sums.row(v);
  }
}

}  // namespace umbilic
