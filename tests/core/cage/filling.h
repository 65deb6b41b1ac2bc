// SPDX-License-Identifier: MIT
/// \file
/// Cages with holes, and what holds of every filled one.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cage/edges.h"
#include "cage/fill.h"

namespace umbilic::test {

/// `rows` + 1 circles of n points, joined by quads that face away from the axis: open at both ends. Its radius is
/// 1 + flare · the distance from the middle.
inline Cage tube(int n, int rows, double flare = 0) {
  Cage cage;
  cage.vertices.resize(n * (rows + 1), 3);
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < n; ++i) {
      const double z = j - rows / 2., radius = 1 + flare * std::abs(z), angle = 2 * std::numbers::pi * i / n;
      cage.vertices.row(j * n + i) << radius * std::cos(angle), radius * std::sin(angle), z;
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      cage.faces.push_back({j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i});
    }
  }
  return cage;
}

/// A flat ring around a hole of n points on the unit circle.
inline Cage washer(int n, int rows = 1) {
  Cage cage = tube(n, rows);
  for (auto row : cage.vertices.rowwise()) {
    const double z = row.z() + rows / 2.;
    row *= 1 + 2 * std::numbers::pi / n * (rows - z);
    row.z() = 0;
  }
  return cage;
}

/// The cage without its faces around a vertex.
inline Cage without_star(Cage cage, int vertex) {
  std::vector<std::vector<int>> kept;
  for (const std::vector<int>& face : cage.faces) {
    if (std::find(face.begin(), face.end(), vertex) == face.end()) kept.push_back(face);
  }
  cage.faces = kept;
  return cage;
}

inline std::vector<int> edge_counts(const Cage& cage) {
  std::vector<int> counts(cage.vertices.rows(), 0);
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) ++counts[v];
  }
  return counts;
}

/// The neighbour of a vertex that is not below `first`, or -1.
inline int new_neighbour(const Cage& cage, int vertex, int first) {
  for (const EdgeUse& use : edge_uses(cage)) {
    if (use.low == vertex && use.high >= first) return use.high;
  }
  return -1;
}

inline double shortest_distance(const Points& points) {
  double shortest = 1e300;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) shortest = std::min(shortest, (points.row(i) - points.row(j)).norm());
  }
  return shortest;
}

inline int euler_characteristic(const Cage& cage) {
  const std::vector<int> used = edge_counts(cage);
  const auto vertices = used.size() - std::count(used.begin(), used.end(), 0);
  const std::vector<EdgeUse> uses = edge_uses(cage);
  int edges = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) edges += i == 0 || !same_edge(uses[i - 1], uses[i]);
  return static_cast<int>(vertices) - edges + static_cast<int>(cage.faces.size());
}

/// Expects a closed cage whose faces agree and in which what was there is as it was, or refined.
inline FilledCage expect_closed(const Cage& open, const FillOptions& options = {}) {
  const Result<FilledCage> filled = fill(open, options);
  EXPECT_TRUE(filled.ok()) << filled.error().message;
  if (!filled) return {};
  const Cage& cage = filled->cage;
  Cage validated = cage;
  const Result<CageReport> report = validate(validated);
  EXPECT_TRUE(report.ok()) << report.error().message;
  // Not by `validate`, which would turn them.
  const std::vector<EdgeUse> uses = edge_uses(cage);
  for (std::size_t i = 0; i < uses.size(); i += 2) EXPECT_NE(uses[i].forward, uses[i + 1].forward) << "faces agree";
  std::size_t first = cage.faces.size();
  for (const FilledLoop& loop : filled->loops) {
    for (const int f : loop.faces) EXPECT_EQ(cage.faces[f].size(), 4u);
    first = std::min<std::size_t>(first, loop.faces.front());
    EXPECT_FALSE(loop.vertices.empty());
  }
  if (!filled->refined) {
    for (std::size_t f = 0; f < first; ++f) EXPECT_EQ(cage.faces[f], open.faces[f]);
    EXPECT_EQ(cage.vertices.topRows(open.vertices.rows()), open.vertices) << "to the last bit";
  } else {
    EXPECT_EQ(first, [&] {
      std::size_t corners = 0;
      for (const auto& face : open.faces) corners += face.size();
      return corners;
    }());
  }
  std::size_t added = 0;
  for (const FilledLoop& loop : filled->loops) added += loop.faces.size();
  EXPECT_EQ(first + added, cage.faces.size()) << "new faces are last";
  return *filled;
}

}  // namespace umbilic::test
