// SPDX-License-Identifier: MIT
/// \file
/// Gauss-Legendre rules on a face, graded towards an extraordinary vertex at (0, 0).
#pragma once

#include <Eigen/Core>
#include <compare>
#include <vector>

namespace umbilic {

struct GaussRule {
  Eigen::VectorXd nodes;    ///< in (0, 1), sorted
  Eigen::VectorXd weights;  ///< sum to 1
};

/// `points` >= 1 nodes, exact for degree 2 points - 1.
GaussRule gauss_legendre(int points);

struct Sample {
  double u, v;
  double weight;
};

/// points^2 samples of the unit square.
std::vector<Sample> tensor_rule(int points);

/// Splits the unit square `grading` times towards (0, 0). Each split adds three cells, and one cell remains at the
/// corner; each cell has points^2 samples.
std::vector<Sample> graded_rule(int points, int grading);

/// Numbers of points of the rules on a mesh.
struct QuadratureRule {
  int regular_points;  ///< per direction on regular faces
  int cap_points;      ///< per direction on each cell of a face that a cap changes
  int grading;         ///< splits of the faces at an extraordinary vertex

  friend auto operator<=>(const QuadratureRule&, const QuadratureRule&) = default;
};

}  // namespace umbilic
