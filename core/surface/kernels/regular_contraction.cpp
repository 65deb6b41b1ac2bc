// SPDX-License-Identifier: MIT
/// \file
/// Contracts the points with the basis in u first, then in v, vectorized over the nodes along u.
#include "surface/kernels/regular_contraction.h"

#include "base/lanes.h"
#include "surface/derivative_order.h"

namespace umbilic::UMBILIC_KERNELS {
namespace {

constexpr int highest_order(int derivatives) {
  return derivatives == kFirstOrderCount ? 1 : derivatives == kSecondOrderCount ? 2 : 3;
}

constexpr int padded(int points) { return (points + kSampleMultiple - 1) / kSampleMultiple * kSampleMultiple; }

/// Number of coordinates processed together, so that four sums of each stay in registers.
constexpr int kTile = 3;

template <int kPoints>
struct Constant {
  constexpr operator int() const { return kPoints; }
};

/// Calls `body` with the number of points as a compile-time constant if unrolling its loops is worthwhile.
template <class Body>
void with_points(int points, const Body& body) {
  switch (points) {
    case 4: return body(Constant<4>());
    case 7: return body(Constant<7>());
    default: return body(points);
  }
}

template <class Count>
void jets_on(Count count, const RegularGrid& grid, const double* points, int derivatives, double* jets) {
  const int order = highest_order(derivatives), width = padded(count), sample_count = count * width;
  const double *along_u = grid.along_u, *along_v = grid.along_v;
  double* partial = grid.partial;
  for (int c = 0; c < 3; ++c) {
    for (int b = 0; b < 4; ++b) {
      const double* p = points + 12 * b + c;
      const ShortLanes p0 = splat<ShortLanes>(p[0]), p1 = splat<ShortLanes>(p[3]), p2 = splat<ShortLanes>(p[6]),
                       p3 = splat<ShortLanes>(p[9]);
      for (int k = 0; k <= order; ++k) {
        const double* basis = along_u + 4 * k * width;
        double* out = partial + ((4 * c + k) * 4 + b) * width;
        for (int i = 0; i < width; i += kShortLaneCount) {
          store_lanes(out + i, load_lanes<ShortLanes>(basis + i) * p0 + load_lanes<ShortLanes>(basis + width + i) * p1 +
                                   load_lanes<ShortLanes>(basis + 2 * width + i) * p2 +
                                   load_lanes<ShortLanes>(basis + 3 * width + i) * p3);
        }
      }
    }
  }
  for (int c = 0; c < 3; c += kTile) {
    for (int k = 0; k <= order; ++k) {
      for (int i = 0; i < width; i += kShortLaneCount) {
        ShortLanes in[kTile][4];
        for (int t = 0; t < kTile; ++t) {
          for (int b = 0; b < 4; ++b) {
            in[t][b] = load_lanes<ShortLanes>(partial + ((4 * (c + t) + k) * 4 + b) * width + i);
          }
        }
        for (int l = k == 0 ? 1 : 0; k + l <= order; ++l) {
          const double* w = along_v + count * l * 4;
          double* out = jets + (c * derivatives + derivative_index(k, l) - 1) * sample_count + i;
          for (int j = 0; j < count; ++j, w += 4, out += width) {
            const ShortLanes w0 = splat<ShortLanes>(w[0]), w1 = splat<ShortLanes>(w[1]), w2 = splat<ShortLanes>(w[2]),
                             w3 = splat<ShortLanes>(w[3]);
            for (int t = 0; t < kTile; ++t) {
              store_lanes(out + t * derivatives * sample_count,
                          in[t][0] * w0 + in[t][1] * w1 + in[t][2] * w2 + in[t][3] * w3);
            }
          }
        }
      }
    }
  }
}

template <class Count>
void pull_back_on(Count count, const RegularGrid& grid, const double* adjoint, int derivatives, double* gradient) {
  const int order = highest_order(derivatives), width = padded(count), sample_count = count * width;
  double* partial = grid.partial;
  for (int c = 0; c < 3; c += kTile) {
    for (int k = 0; k <= order; ++k) {
      for (int i = 0; i < width; i += kShortLaneCount) {
        ShortLanes sums[kTile][4] = {};
        for (int l = k == 0 ? 1 : 0; k + l <= order; ++l) {
          const double* in = adjoint + (c * derivatives + derivative_index(k, l) - 1) * sample_count + i;
          const double* w = grid.along_v + count * l * 4;
          for (int j = 0; j < count; ++j, w += 4, in += width) {
            ShortLanes x[kTile];
            for (int t = 0; t < kTile; ++t) x[t] = load_lanes<ShortLanes>(in + t * derivatives * sample_count);
            for (int b = 0; b < 4; ++b) {
              const ShortLanes factor = splat<ShortLanes>(w[b]);
              for (int t = 0; t < kTile; ++t) sums[t][b] += x[t] * factor;
            }
          }
        }
        for (int t = 0; t < kTile; ++t) {
          for (int b = 0; b < 4; ++b) store_lanes(partial + ((4 * (c + t) + k) * 4 + b) * width + i, sums[t][b]);
        }
      }
    }
  }
  for (int c = 0; c < 3; ++c) {
    for (int b = 0; b < 4; ++b) {
      ShortLanes total[4] = {};
      for (int k = 0; k <= order; ++k) {
        for (int i = 0; i < width; i += kShortLaneCount) {
          const ShortLanes x = load_lanes<ShortLanes>(partial + ((4 * c + k) * 4 + b) * width + i);
          for (int a = 0; a < 4; ++a) total[a] += x * load_lanes<ShortLanes>(grid.along_u + (4 * k + a) * width + i);
        }
      }
      double sums[4];
      sum_lanes_of_four(total, sums);
      for (int a = 0; a < 4; ++a) gradient[(4 * b + a) * 3 + c] += sums[a];
    }
  }
}

}  // namespace

void regular_jets(const RegularGrid& grid, const double* points, int derivatives, double* jets) {
  with_points(grid.points, [&](auto count) { jets_on(count, grid, points, derivatives, jets); });
}

void pull_back_regular_jets(const RegularGrid& grid, const double* adjoint, int derivatives, double* gradient) {
  with_points(grid.points, [&](auto count) { pull_back_on(count, grid, adjoint, derivatives, gradient); });
}

}  // namespace umbilic::UMBILIC_KERNELS
