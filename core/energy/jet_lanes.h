// SPDX-License-Identifier: MIT
/// \file
/// Loads and stores jets of consecutive samples as lanes.
#pragma once

#include "base/lanes.h"
#include "energy/curvature.h"
#include "surface/derivative_order.h"

namespace umbilic::UMBILIC_KERNELS {

/// The three coordinates of one derivative at consecutive samples.
template <class L = Lanes>
Vec3<L> load_vector(const double* x, int stride) {
  return {load_lanes<L>(x), load_lanes<L>(x + stride), load_lanes<L>(x + 2 * stride)};
}

template <class L>
void store_vector(double* x, int stride, const Vec3<L>& v) {
  store_lanes(x, v.x);
  store_lanes(x + stride, v.y);
  store_lanes(x + 2 * stride, v.z);
}

/// `x` points to the first of the samples, in an array [(c * derivatives + d) * samples + s].
template <bool kThird, class L = Lanes>
Jet<L> load_jet(const double* x, int samples, int derivatives) {
  const int stride = derivatives * samples;
  const auto at = [&](int d) { return load_vector<L>(x + d * samples, stride); };
  if constexpr (kThird) return {{at(0), at(1)}, {at(2), at(3), at(4)}, {at(5), at(6), at(7), at(8)}};
  return {{at(0), at(1)}, {at(2), at(3), at(4)}, {}};
}

template <bool kThird, class L>
void store_jet(double* x, int samples, const Jet<L>& jet) {
  const int stride = (kThird ? kThirdOrderCount : kSecondOrderCount) * samples;
  for (int d = 0; d < 2; ++d) store_vector(x + d * samples, stride, jet.first[d]);
  for (int d = 0; d < 3; ++d) store_vector(x + (2 + d) * samples, stride, jet.second[d]);
  if constexpr (kThird) {
    for (int d = 0; d < 4; ++d) store_vector(x + (5 + d) * samples, stride, jet.third[d]);
  }
}

}  // namespace umbilic::UMBILIC_KERNELS
