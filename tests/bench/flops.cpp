// SPDX-License-Identifier: MIT
/// \file
/// Runs the densities on numbers that count, and multiplies out the lengths of the contractions' loops.
#include "flops.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "counted.h"
#include "energy/densities.h"
#include "solve/elimination_tree.h"

namespace umbilic {
namespace {

int highest_order(int derivatives) {
  return derivatives == kFirstOrderCount ? 1 : derivatives == kSecondOrderCount ? 2 : 3;
}

/// Adds the densities of one order and their adjoints, as energy/kernels/integrals.cpp does.
template <bool kThird, class Frame>
void density_and_pull_back(const Frame& frame, const Weights& weights, Counted weight) {
  const Curvature<Counted>& k = frame.value();
  Curvature<Counted> adjoint{};
  const Counted measure = weight * k.area;
  const Counted density = kThird ? third_order_density(weights.data(), k, measure, adjoint)
                                 : weighted_density<0>(weights.data(), k, measure, adjoint);
  adjoint.area = weight * density;
  Counted sum;
  sum += measure * density;
  (void)frame.template pull_back<kThird>(adjoint);
}

template <bool kThird>
double sample_flops(const Weights& weights, bool second) {
  Jet<Counted> jet;
  jet.first[0] = {1, 0.1, 0};
  jet.first[1] = {0, 1, 0.1};
  jet.second[1] = {0, 0.3, 0.2};
  Counted::operations = 0;
  const CurvatureFrame<Counted, kThird> frame(jet);
  const Curvature<Counted>& k = frame.value();
  Counted area, gaussian;
  const Counted measure = Counted(1) * k.area;
  area += measure;
  gaussian += measure * (k.p * k.r - k.q * k.q);
  if (second) density_and_pull_back<false>(frame, weights, 1);
  if constexpr (kThird) {
    density_and_pull_back<true>(frame, weights, 1);
    const Vec3<Counted> n = frame.normal() * Counted(1);
    (void)cross(jet.first[1], n);
    (void)cross(n, jet.first[0]);
  }
  return static_cast<double>(Counted::operations);
}

}  // namespace

double evaluation_flops(const PatchLayout& layout, const QuadratureRule& rule, const Weights& weights) {
  const bool second = weights[kBending] != 0 || weights[kWillmore] != 0;
  const bool third = std::any_of(weights.begin() + kMvs, weights.end(), [](double w) { return w != 0; });
  std::vector<int> passes{third ? kThirdOrderCount
                                : kSecondOrderCount};  // derivatives of the jets, then of each channel
  if (second) passes.push_back(kSecondOrderCount);
  if (third) passes.insert(passes.end(), {kThirdOrderCount, kFirstOrderCount});
  const double per_sample = third ? sample_flops<true>(weights, second) : sample_flops<false>(weights, second);

  double flops = 0;
  for (const PatchSet& set : layout.sets()) {
    const int n = set.kind.regular() ? rule.regular_points : rule.cap_points;
    const double samples = n * n * (set.kind.at_extraordinary() ? 3 * rule.grading + 1 : 1);
    double multiply_adds = 0;
    for (const int derivatives : passes) {
      if (set.kind.regular()) {
        multiply_adds += 3 * 4 * 4 * (highest_order(derivatives) + 1) * n + 3 * 4 * derivatives * samples;
      } else {
        const int products = set.kind.shape == CapShape::kFlat ? 4 : 3;
        multiply_adds += products * set.columns * derivatives * samples;
      }
    }
    flops += set.count() * (2 * multiply_adds + per_sample * samples);
  }
  return flops;
}

double factorization_flops(const Eigen::SparseMatrix<double>& lower) {
  const EliminationTree tree(lower);
  return std::accumulate(tree.supernodes().begin(), tree.supernodes().end(), 0.0,
                         [](double sum, const Supernode& supernode) { return sum + supernode.flops(); });
}

}  // namespace umbilic
