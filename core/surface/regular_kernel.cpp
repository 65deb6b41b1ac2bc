// SPDX-License-Identifier: MIT
/// \file
/// The basis at the nodes; the contractions are kernels.
#include "surface/regular_kernel.h"

#include <algorithm>

#include "base/lanes.h"
#include "surface/bspline.h"

namespace umbilic {

RegularKernel::RegularKernel(int points_per_direction)
    : points_(points_per_direction),
      width_((points_per_direction + kSampleMultiple - 1) / kSampleMultiple * kSampleMultiple) {
  const GaussRule rule = gauss_legendre(points_);
  along_u_.resize(16 * width_);
  along_v_.resize(16 * points_);
  weights_ = Eigen::VectorXd::Zero(samples());
  for (int i = 0; i < width_; ++i) {
    const Eigen::Matrix4d basis = cubic_bspline(rule.nodes[std::min(i, points_ - 1)]);
    for (int k = 0; k < 4; ++k) {
      for (int a = 0; a < 4; ++a) {
        along_u_[(4 * k + a) * width_ + i] = basis(k, a);
        if (i < points_) along_v_[(points_ * k + i) * 4 + a] = basis(k, a);
      }
    }
    for (int j = 0; j < points_ && i < points_; ++j) weights_[j * width_ + i] = rule.weights[i] * rule.weights[j];
  }
}

void RegularKernel::jets(const double* points, int derivatives, double* jets, double* scratch) const {
  surface_kernels().regular_jets(grid(scratch), points, derivatives, jets);
}

void RegularKernel::pull_back(const double* adjoint, int derivatives, double* gradient, double* scratch) const {
  surface_kernels().pull_back_regular_jets(grid(scratch), adjoint, derivatives, gradient);
}

}  // namespace umbilic
