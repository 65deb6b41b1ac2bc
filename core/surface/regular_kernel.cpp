// SPDX-License-Identifier: MIT
/// \file
/// The two contractions of the tensor product, in lanes over the nodes along u.
#include "surface/regular_kernel.h"

#include <algorithm>
#include <type_traits>

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

namespace {

/// Calls `body` with the number of points as a constant where the loops over it are worth unrolling.
template <class Body>
void with_points(int points, const Body& body) {
  switch (points) {
    case 4: return body(std::integral_constant<int, 4>());
    case 7: return body(std::integral_constant<int, 7>());
    default: return body(points);
  }
}

constexpr int padded(int points) { return (points + kLaneCount - 1) / kLaneCount * kLaneCount; }

}  // namespace

void RegularKernel::jets(const double* points, int derivatives, double* jets) const {
  with_points(points_, [&](auto count) { this->jets_on(count, points, derivatives, jets); });
}

void RegularKernel::pull_back(const double* adjoint, int derivatives, double* gradient) const {
  with_points(points_, [&](auto count) { this->pull_back_on(count, adjoint, derivatives, gradient); });
}

template <class Count>
void RegularKernel::jets_on(Count count, const double* points, int derivatives, double* jets) const {
  const int order = highest_order(derivatives), width = padded(count), sample_count = count * width;
  const double* along_u = along_u_.data();
  const double* along_v = along_v_.data();
  double* partial = partial_.data();
  for (int c = 0; c < 3; ++c) {
    for (int b = 0; b < 4; ++b) {
      const double* p = points + 12 * b + c;
      const Lanes p0 = splat(p[0]), p1 = splat(p[3]), p2 = splat(p[6]), p3 = splat(p[9]);
      for (int k = 0; k <= order; ++k) {
        const double* basis = along_u + 4 * k * width;
        double* out = partial + ((4 * c + k) * 4 + b) * width;
        for (int i = 0; i < width; i += kLaneCount) {
          store_lanes(out + i, load_lanes(basis + i) * p0 + load_lanes(basis + width + i) * p1 +
                                   load_lanes(basis + 2 * width + i) * p2 + load_lanes(basis + 3 * width + i) * p3);
        }
      }
    }
  }
  for (int c = 0; c < 3; ++c) {
    for (int d = 0; d < derivatives; ++d) {
      const int k = kOrderU[d + 1], l = kOrderV[d + 1];
      const double* in = partial + (4 * c + k) * 4 * width;
      double* out = jets + (c * derivatives + d) * sample_count;
      for (int i = 0; i < width; i += kLaneCount) {
        const Lanes p0 = load_lanes(in + i), p1 = load_lanes(in + width + i), p2 = load_lanes(in + 2 * width + i),
                    p3 = load_lanes(in + 3 * width + i);
        const double* w = along_v + count * l * 4;
        for (int j = 0; j < count; ++j, w += 4) {
          store_lanes(out + j * width + i, p0 * splat(w[0]) + p1 * splat(w[1]) + p2 * splat(w[2]) + p3 * splat(w[3]));
        }
      }
    }
  }
}

template <class Count>
void RegularKernel::pull_back_on(Count count, const double* adjoint, int derivatives, double* gradient) const {
  const int order = highest_order(derivatives), width = padded(count), sample_count = count * width;
  double* partial = partial_.data();  // [k][b][i] of one coordinate
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k <= order; ++k) {
      for (int i = 0; i < width; i += kLaneCount) {
        Lanes sum[4] = {};
        for (int l = 0; k + l <= order; ++l) {
          if (k + l == 0) continue;
          const double* in = adjoint + (c * derivatives + derivative_index(k, l) - 1) * sample_count + i;
          const double* w = along_v_.data() + count * l * 4;
          for (int j = 0; j < count; ++j, w += 4) {
            const Lanes x = load_lanes(in + j * width);
            for (int b = 0; b < 4; ++b) sum[b] += x * splat(w[b]);
          }
        }
        for (int b = 0; b < 4; ++b) store_lanes(partial + (4 * k + b) * width + i, sum[b]);
      }
    }
    for (int b = 0; b < 4; ++b) {
      Lanes total[4] = {};
      for (int k = 0; k <= order; ++k) {
        for (int i = 0; i < width; i += kLaneCount) {
          const Lanes x = load_lanes(partial + (4 * k + b) * width + i);
          for (int a = 0; a < 4; ++a) total[a] += x * load_lanes(along_u_.data() + (4 * k + a) * width + i);
        }
      }
      for (int a = 0; a < 4; ++a) gradient[(4 * b + a) * 3 + c] += sum_lanes(total[a]);
    }
  }
}

}  // namespace umbilic
