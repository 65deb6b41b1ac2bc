// SPDX-License-Identifier: MIT
/// \file
/// The rule of Clenshaw and Curtis on [0, 1]: the integral of the interpolating polynomial through the extrema of a
/// Chebyshev polynomial. Every second of its points are those of the rule with half as many intervals.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace umbilic::opinion {

struct NestedRule {
  std::vector<double> nodes;    ///< from 0 to 1
  std::vector<double> weights;  ///< sum to 1
  std::vector<double> coarse;   ///< those of the rule on every second node; 0 at the others
};

/// The weights for `intervals`, an even number (Waldvogel 2006, with the cosines summed one by one).
inline std::vector<double> clenshaw_curtis_weights(int intervals) {
  std::vector<double> weights(intervals + 1);
  for (int i = 0; i <= intervals; ++i) {
    double sum = 1;
    for (int k = 1; k <= intervals / 2; ++k) {
      const double once = 2 * k == intervals ? 1 : 2;
      sum -= once / (4.0 * k * k - 1) * std::cos(2 * std::numbers::pi * k * i / intervals);
    }
    weights[i] = sum / intervals * (i == 0 || i == intervals ? 0.5 : 1);
  }
  return weights;
}

/// `intervals` is a multiple of 4.
inline NestedRule clenshaw_curtis(int intervals) {
  NestedRule rule{{}, clenshaw_curtis_weights(intervals), std::vector<double>(intervals + 1, 0.0)};
  for (int i = 0; i <= intervals; ++i) {
    const double sine = std::sin(std::numbers::pi * i / (2 * intervals));
    rule.nodes.push_back(sine * sine);
  }
  const std::vector<double> half = clenshaw_curtis_weights(intervals / 2);
  for (int i = 0; i <= intervals / 2; ++i) rule.coarse[2 * i] = half[i];
  return rule;
}

}  // namespace umbilic::opinion
