// SPDX-License-Identifier: MIT
/// \file
/// The least squares are solved by conjugate gradients, which keep every symmetry of the fill.
#include "cage/fill_positions.h"

#include <algorithm>
#include <set>

namespace umbilic {

namespace {

/// The neighbours of each vertex, rising.
std::vector<std::vector<int>> neighbours_of(const FillQuads& fill) {
  std::vector<std::set<int>> sets(fill.points.size());
  for (const std::array<int, 4>& quad : fill.quads) {
    for (int i = 0; i < 4; ++i) {
      sets[quad[i]].insert(quad[(i + 1) % 4]);
      sets[quad[(i + 1) % 4]].insert(quad[i]);
    }
  }
  std::vector<std::vector<int>> neighbours;
  for (const std::set<int>& set : sets) neighbours.emplace_back(set.begin(), set.end());
  return neighbours;
}

/// The new vertex across the loop from each of its vertices, or -1.
std::vector<int> across_the_loop(const FillQuads& fill, const std::vector<std::vector<int>>& neighbours) {
  std::vector<int> across(fill.loop, -1);
  std::vector<bool> corner(fill.loop, true);
  for (int v = 0; v < fill.loop; ++v) {
    for (const int u : neighbours[v]) {
      if (u == (v + 1) % fill.loop || v == (u + 1) % fill.loop) continue;
      corner[v] = false;
      if (u >= fill.loop) across[v] = u;
    }
  }
  for (const std::array<int, 4>& quad : fill.quads) {
    for (int i = 0; i < 4; ++i) {
      const int v = quad[i], u = quad[(i + 2) % 4];
      if (v < fill.loop && corner[v] && u >= fill.loop) across[v] = u;
    }
  }
  return across;
}

/// Rows of residuals: coefficients of the new vertices, less the right side.
struct LeastSquares {
  struct Term {
    int column;
    double factor;
  };
  std::vector<std::vector<Term>> rows;
  std::vector<Vector3> right;

  std::vector<Vector3> residuals(const std::vector<Vector3>& x) const {
    std::vector<Vector3> r = times(x);
    for (std::size_t i = 0; i < rows.size(); ++i) r[i] = right[i] - r[i];
    return r;
  }
  std::vector<Vector3> times(const std::vector<Vector3>& x) const {
    std::vector<Vector3> y(rows.size(), Vector3::Zero());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const auto& [column, factor] : rows[i]) y[i] += factor * x[column];
    }
    return y;
  }
  std::vector<Vector3> transposed_times(const std::vector<Vector3>& y, std::size_t columns) const {
    std::vector<Vector3> x(columns, Vector3::Zero());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const auto& [column, factor] : rows[i]) x[column] += factor * y[i];
    }
    return x;
  }
};

double square(const std::vector<Vector3>& x) {
  double sum = 0;
  for (const Vector3& point : x) sum += point.squaredNorm();
  return sum;
}

/// Conjugate gradients on the normal equations.
void solve(const LeastSquares& problem, std::vector<Vector3>& x) {
  constexpr int kMostIterations = 3000;  // a limit for the longest loops
  constexpr double kTolerance = 1e-15;
  std::vector<Vector3> residual = problem.residuals(x);
  std::vector<Vector3> gradient = problem.transposed_times(residual, x.size());
  std::vector<Vector3> direction = gradient;
  double now = square(gradient);
  const double end = kTolerance * kTolerance * square(problem.transposed_times(problem.right, x.size()));
  for (int i = 0; i < kMostIterations && now > end; ++i) {
    const std::vector<Vector3> change = problem.times(direction);
    const double step = now / square(change);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += step * direction[k];
    for (std::size_t k = 0; k < residual.size(); ++k) residual[k] -= step * change[k];
    gradient = problem.transposed_times(residual, x.size());
    const double next = square(gradient);
    for (std::size_t k = 0; k < x.size(); ++k) direction[k] = gradient[k] + next / now * direction[k];
    now = next;
  }
}

}  // namespace

void smooth_fill(FillQuads& fill, const std::vector<Vector3>& directions) {
  // Relative to the loop's middle, so that rounding does not depend on where the cage is.
  Vector3 middle = Vector3::Zero();
  for (int v = 0; v < fill.loop; ++v) middle += fill.points[v] / fill.loop;
  for (Vector3& point : fill.points) point -= middle;

  const std::vector<std::vector<int>> neighbours = neighbours_of(fill);
  const std::vector<int> across = across_the_loop(fill, neighbours);
  LeastSquares problem;
  for (int v = 0; v < fill.loop; ++v) {
    if (across[v] < 0) continue;
    const double distance = (fill.points[across[v]] - fill.points[v]).norm();
    problem.rows.push_back({{across[v] - fill.loop, 1}});
    problem.right.push_back(fill.points[v] + distance * directions[v]);
  }
  for (int u = fill.loop; u < static_cast<int>(fill.points.size()); ++u) {
    std::vector<LeastSquares::Term> row{{u - fill.loop, 1}};
    Vector3 right = Vector3::Zero();
    const double share = 1. / static_cast<double>(neighbours[u].size());
    for (const int v : neighbours[u]) {
      if (v < fill.loop) {
        right += share * fill.points[v];
      } else {
        row.push_back({v - fill.loop, -share});
      }
    }
    problem.rows.push_back(row);
    problem.right.push_back(right);
  }
  std::vector<Vector3> points(fill.points.begin() + fill.loop, fill.points.end());
  if (!points.empty()) solve(problem, points);
  std::copy(points.begin(), points.end(), fill.points.begin() + fill.loop);
  for (Vector3& point : fill.points) point += middle;
}

}  // namespace umbilic
