// SPDX-License-Identifier: MIT
/// \file
/// The search for the least weight that keeps a surface within a given distance.
///
///     ClosenessSearch search(bound, first_weight);
///     while (!search.accepts(deviation_with(search.weight()))) {
///     }
#pragma once

#include <optional>

namespace umbilic {

/// The larger the weight, the smaller the deviation. Weights are interpolated on logarithmic scales.
class ClosenessSearch {
 public:
  /// What is accepted: deviations in [kLeast, 1] times the bound.
  static constexpr double kLeast = 0.9;
  /// A weight that is smaller than the first by this factor and still leaves the deviation below the bound does not
  /// matter: the surface stays near by itself.
  static constexpr double kNoWeight = 1e-9;
  static constexpr int kMostTrials = 40;

  /// `bound` > 0, `weight` > 0.
  ClosenessSearch(double bound, double weight) : bound_(bound), weight_(weight), first_weight_(weight) {}

  double weight() const { return weight_; }
  /// Takes the deviation of the surface with this weight. Returns false if `weight` should be tried next.
  bool accepts(double deviation);
  /// Whether the accepted weight matters.
  bool binds() const { return weight_ > kNoWeight * first_weight_; }

 private:
  struct Trial {
    double weight, deviation;
  };

  double bound_, weight_, first_weight_;
  std::optional<Trial> too_far_, too_near_;  // the nearest trials on both sides
  int trials_ = 0;
};

}  // namespace umbilic
