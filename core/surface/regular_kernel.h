// SPDX-License-Identifier: MIT
/// \file
/// Sum-factorized evaluation of bicubic patches on a tensor grid of samples, and its transpose.
///
/// With B_k the k-th derivatives of the four B-splines at the nodes, the derivative (k, l) at (node i, node j) is
/// sum_b B_l[j][b] (sum_a B_k[i][a] P[b][a]): the inner sum is shared by all j and l. Loops over the nodes along u are
/// vectorized.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/quadrature.h"
#include "surface/surface_kernels.h"

namespace umbilic {

class RegularKernel {
 public:
  /// The tensor product of the Gauss rule. Nodes along u are padded to a multiple of kSampleMultiple with weight 0.
  explicit RegularKernel(int points_per_direction);

  int samples() const { return width_ * points_; }
  const Eigen::VectorXd& weights() const { return weights_; }  ///< sample (i, j) is entry j * width + i
  std::size_t bytes() const { return sizeof(double) * (along_u_.size() + along_v_.size() + weights_.size()); }

  /// How many doubles of scratch memory the functions below need.
  int scratch_size() const { return 3 * 16 * width_; }

  /// jets[(c * derivatives + d) * samples + s] of order 1 and up from the points[16][3]; `derivatives` is 2, 5 or 9.
  void jets(const double* points, int derivatives, double* jets, double* scratch) const;

  /// The transpose: adds the pullback of the adjoints, laid out like the jets, to gradient[16][3].
  void pull_back(const double* adjoint, int derivatives, double* gradient, double* scratch) const;

 private:
  RegularGrid grid(double* scratch) const { return {points_, width_, along_u_.data(), along_v_.data(), scratch}; }

  int points_, width_;
  std::vector<double> along_u_;  // [k][a][i], i < width
  std::vector<double> along_v_;  // [l][j][b]
  Eigen::VectorXd weights_;
};

}  // namespace umbilic
