// SPDX-License-Identifier: MIT
/// \file
/// Corners where the cage turns, or else evenly spaced ones.
#include "cage/fill_pattern.h"

#include <algorithm>
#include <cmath>

namespace umbilic {

namespace {

constexpr int kFewestSides = 3;
constexpr int kMostSides = 12;

/// Positive numbers x_0, x_1, … around a cycle whose neighbours have the given sums; empty if there are none.
std::vector<int> parts_of(const std::vector<int>& sums) {
  std::vector<std::vector<int>> solutions;
  for (int first = 1; first < sums[0]; ++first) {
    std::vector<int> parts{first};
    for (const int sum : sums) parts.push_back(sum - parts.back());
    if (parts.back() != first || *std::min_element(parts.begin(), parts.end()) < 1) continue;
    parts.pop_back();
    solutions.push_back(parts);
  }
  return solutions.empty() ? std::vector<int>() : solutions[(solutions.size() - 1) / 2];
}

/// The angle by which the loop turns at the vertex i, in [0, pi].
double turn(const std::vector<Vector3>& points, std::size_t i) {
  const std::size_t n = points.size();
  const Vector3 before = points[i] - points[(i + n - 1) % n], after = points[(i + 1) % n] - points[i];
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

/// Sides of a patch within a smooth loop of even length.
std::vector<int> even_sides(int length) {
  const auto equal = [&](int sides) { return std::vector<int>(sides, length / sides); };
  for (const int sides : {4, 5, 3}) {
    // More sides than four have a vertex in the middle, and each a middle too.
    if (length % (sides == 4 ? 4 : 2 * sides) == 0) return equal(sides);
  }
  const int shorter = (length / 2 - 1) / 2, longer = shorter + 1;
  return {shorter, longer, shorter, longer};
}

/// The corners of a patch with these sides where the loop turns most.
std::vector<int> most_turned(const std::vector<Vector3>& points, const std::vector<int>& sides) {
  const auto length = static_cast<int>(points.size());
  std::vector<int> best;
  double most = -1;
  for (int first = 0; first < length; ++first) {
    std::vector<int> corners;
    double sum = 0;
    int at = first;
    for (const int side : sides) {
      corners.push_back(at % length);
      sum += turn(points, at % length);
      at += side;
    }
    constexpr double kRounding = 1e-9;  // so that the first of equal ones is taken
    if (sum <= most + kRounding) continue;
    most = sum;
    best = corners;
  }
  std::sort(best.begin(), best.end());
  return best;
}

}  // namespace

std::vector<int> spokes_of(const std::vector<int>& sides) {
  const std::size_t n = sides.size();
  std::vector<int> spokes(n, 0);
  for (std::size_t first = 0; first < (n % 2 == 0 ? 2 : 1); ++first) {
    std::vector<int> sums;
    for (std::size_t i = first; sums.empty() || i != first; i = (i + 2) % n) sums.push_back(sides[i]);
    const std::vector<int> parts = parts_of(sums);
    if (parts.empty()) return {};
    for (std::size_t k = 0; k < parts.size(); ++k) spokes[(first + 2 * k) % n] = parts[k];
  }
  return spokes;
}

std::vector<int> sides_between(const std::vector<int>& corners, int length) {
  std::vector<int> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool last = i + 1 == corners.size();
    sides.push_back((last ? corners[0] + length : corners[i + 1]) - corners[i]);
  }
  return sides;
}

bool is_patch(const std::vector<int>& sides) {
  const auto count = static_cast<int>(sides.size());
  if (count < kFewestSides || count > kMostSides) return false;
  if (count == 4) return sides[0] == sides[2] && sides[1] == sides[3];
  return !spokes_of(sides).empty();
}

std::optional<FillPattern> fill_pattern(const std::vector<Vector3>& points, const std::vector<int>& faces) {
  const auto length = static_cast<int>(points.size());
  if (length % 2 != 0) return std::nullopt;
  FillPattern pattern;
  for (int i = 0; i < length; ++i) {
    if (faces[i] >= 3) pattern.corners.push_back(i);
  }
  if (const std::vector<int> sides = sides_between(pattern.corners, length); is_patch(sides)) {
    if (sides.size() == 4 && std::min(sides[0], sides[1]) == 1) return std::nullopt;
    return pattern;
  }
  pattern.ring = true;
  pattern.corners = most_turned(points, even_sides(length));
  return pattern;
}

}  // namespace umbilic
