// SPDX-License-Identifier: MIT
/// \file
/// Nodes by Newton's method on the Legendre polynomials.
#include "surface/quadrature.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace umbilic {

GaussRule gauss_legendre(int points) {
  assert(points >= 1);
  GaussRule rule{Eigen::VectorXd(points), Eigen::VectorXd(points)};
  for (int i = 0; i < points; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5)), slope = 0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double current = 1, last = 0;
      for (int k = 1; k <= points; ++k) {
        const double next = ((2 * k - 1) * x * current - (k - 1) * last) / k;
        last = current;
        current = next;
      }
      slope = points * (x * current - last) / (x * x - 1);
      const double change = current / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    rule.nodes[i] = (1 + x) / 2;
    rule.weights[i] = 1 / ((1 - x * x) * slope * slope);
  }
  // Makes the rule exactly symmetric, so that mirrored faces give the same bits.
  for (int i = 0; i < points / 2; ++i) {
    const int mirror = points - 1 - i;
    rule.nodes[mirror] = 1 - rule.nodes[i];
    rule.weights[mirror] = rule.weights[i];
  }
  return rule;
}

std::vector<Sample> tensor_rule(int points) {
  const GaussRule rule = gauss_legendre(points);
  std::vector<Sample> samples;
  for (int j = 0; j < points; ++j) {
    for (int i = 0; i < points; ++i) {
      samples.push_back({rule.nodes[i], rule.nodes[j], rule.weights[i] * rule.weights[j]});
    }
  }
  return samples;
}

std::vector<Sample> graded_rule(int points, int grading) {
  const std::vector<Sample> square = tensor_rule(points);
  std::vector<Sample> samples;
  const auto add_cell = [&](double u, double v, double size) {
    for (const Sample& s : square) samples.push_back({u + size * s.u, v + size * s.v, size * size * s.weight});
  };
  double size = 1;
  for (int level = 0; level < grading; ++level) {
    size /= 2;
    add_cell(size, 0, size);
    add_cell(0, size, size);
    add_cell(size, size, size);
  }
  add_cell(0, 0, size);
  return samples;
}

}  // namespace umbilic
