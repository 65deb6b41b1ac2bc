// SPDX-License-Identifier: MIT
/// \file
/// The two contractions of the tensor product, in lanes over the nodes along u.
#include "surface/regular_kernel.h"

#include <algorithm>

#include "base/lanes.h"
#include "surface/bspline.h"
#include "surface/derivatives.h"

namespace umbilic {
namespace {

constexpr int highest_order(int derivatives) {
  return derivatives == kFirstOrderCount ? 1 : derivatives == kSecondOrderCount ? 2 : 3;
}

}  // namespace

RegularKernel::RegularKernel(int points_per_direction)
    : points_(points_per_direction), width_((points_per_direction + kLaneCount - 1) / kLaneCount * kLaneCount) {
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
  partial_.resize(3 * 16 * width_);
}

void RegularKernel::jets(const double* points, int derivatives, double* jets) const {
  const int order = highest_order(derivatives), width = width_;
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k <= order; ++k) {
      for (int b = 0; b < 4; ++b) {
        const double* p = points + 12 * b + c;
        const double* basis = &along_u_[4 * k * width];
        double* out = &partial_[((4 * c + k) * 4 + b) * width];
        for (int i = 0; i < width; i += kLaneCount) {
          store_lanes(out + i, load_lanes(basis + i) * p[0] + load_lanes(basis + width + i) * p[3] +
                                   load_lanes(basis + 2 * width + i) * p[6] + load_lanes(basis + 3 * width + i) * p[9]);
        }
      }
    }
  }
  const int sample_count = samples();
  for (int c = 0; c < 3; ++c) {
    for (int d = 0; d < derivatives; ++d) {
      const int k = kOrderU[d + 1], l = kOrderV[d + 1];
      const double* in = &partial_[(4 * c + k) * 4 * width];
      double* out = jets + (c * derivatives + d) * sample_count;
      for (int i = 0; i < width; i += kLaneCount) {
        const Lanes p0 = load_lanes(in + i), p1 = load_lanes(in + width + i), p2 = load_lanes(in + 2 * width + i),
                    p3 = load_lanes(in + 3 * width + i);
        for (int j = 0; j < points_; ++j) {
          const double* w = &along_v_[(points_ * l + j) * 4];
          store_lanes(out + j * width + i, p0 * w[0] + p1 * w[1] + p2 * w[2] + p3 * w[3]);
        }
      }
    }
  }
}

void RegularKernel::pull_back(const double* adjoint, int derivatives, double* gradient) const {
  const int order = highest_order(derivatives), width = width_, sample_count = samples();
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < width; i += kLaneCount) {
      Lanes sums[4][4] = {};
      for (int d = 0; d < derivatives; ++d) {
        const int k = kOrderU[d + 1], l = kOrderV[d + 1];
        const double* in = adjoint + (c * derivatives + d) * sample_count + i;
        Lanes* sum = sums[k];
        for (int j = 0; j < points_; ++j) {
          const Lanes x = load_lanes(in + j * width);
          const double* w = &along_v_[(points_ * l + j) * 4];
          for (int b = 0; b < 4; ++b) sum[b] += x * w[b];
        }
      }
      for (int b = 0; b < 4; ++b) {
        for (int a = 0; a < 4; ++a) {
          Lanes total = {};
          for (int k = 0; k <= order; ++k) total += sums[k][b] * load_lanes(&along_u_[(4 * k + a) * width + i]);
          gradient[(4 * b + a) * 3 + c] += sum_lanes(total);
        }
      }
    }
  }
}

}  // namespace umbilic
