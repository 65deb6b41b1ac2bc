// SPDX-License-Identifier: MIT
/// \file
/// Open cages with every kind of boundary vertex, moved at random so that no symmetry hides an error.
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "mesh/rough_cages.h"

namespace umbilic::test {

/// A bent sheet of m x n quads: four corners of one face, all else regular.
inline Cage sheet(int m, int n) {
  Cage cage{Points((m + 1) * (n + 1), 3), {}};
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= m; ++i) {
      cage.vertices.row(j * (m + 1) + i) << i, j, 0.2 * std::sin(1.0 * i) + 0.1 * j * j / n;
      if (i < m && j < n) {
        const int v = j * (m + 1) + i;
        cage.faces.push_back({v, v + 1, v + m + 2, v + m + 1});
      }
    }
  }
  return cage;
}

/// A tube of n x m quads between two circles.
inline Cage tube(int n, int m, double height = 2) {
  Cage cage{Points(n * (m + 1), 3), {}};
  for (int j = 0; j <= m; ++j) {
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      cage.vertices.row(j * n + i) << std::cos(angle), std::sin(angle), height * j / m - height / 2;
      const int next = (i + 1) % n;
      if (j < m) cage.faces.push_back({j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i});
    }
  }
  return cage;
}

/// k quads around a vertex on the boundary.
inline Cage half_disc(int k) {
  Cage cage{Points(2 * k + 2, 3), {}};
  cage.vertices.row(0) << 0, 0, 0.1;
  const double step = std::numbers::pi / (2 * k);
  for (int i = 0; i <= 2 * k; ++i) {
    const double angle = i * step, radius = i % 2 == 0 ? 1 : 1 / std::cos(step);
    cage.vertices.row(1 + i) << radius * std::cos(angle), radius * std::sin(angle), 0.2 * std::cos(3 * angle);
  }
  for (int i = 0; i < k; ++i) cage.faces.push_back({0, 1 + 2 * i, 2 + 2 * i, 3 + 2 * i});
  return cage;
}

/// n quads around an inner vertex: extraordinary one edge from the boundary, on which corners alternate with regular
/// vertices.
inline Cage disc(int n) {
  Cage cage{Points(2 * n + 1, 3), {}};
  cage.vertices.row(0) << 0, 0, 0.3;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = std::numbers::pi * i / n;
    cage.vertices.row(1 + i) << std::cos(angle), std::sin(angle), 0.1 * std::sin(2 * angle);
    if (i % 2 == 0) cage.faces.push_back({0, 1 + i, 2 + i, 1 + (i + 2) % (2 * n)});
  }
  return cage;
}

/// One polygon.
inline Cage polygon(int n) {
  Cage cage{Points(n, 3), std::vector<std::vector<int>>(1)};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    cage.vertices.row(i) << std::cos(angle), std::sin(angle), 0.1 * std::cos(2 * angle);
    cage.faces[0].push_back(i);
  }
  return cage;
}

/// A cage without some faces, and without the vertices that only they use.
inline Cage without(const Cage& cage, const std::vector<int>& removed) {
  std::vector<bool> gone(cage.faces.size(), false);
  for (const int f : removed) gone[f] = true;
  std::vector<int> number(cage.vertices.rows(), -1);
  Cage result;
  std::vector<int> kept;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    if (gone[f]) continue;
    result.faces.push_back(cage.faces[f]);
    for (int& v : result.faces.back()) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(kept.size());
        kept.push_back(v);
      }
      v = number[v];
    }
  }
  result.vertices = cage.vertices(kept, Eigen::all);
  return result;
}

inline Cage joined(const Cage& a, const Cage& b) {
  Cage cage{Points(a.vertices.rows() + b.vertices.rows(), 3), a.faces};
  cage.vertices << a.vertices, b.vertices.rowwise() + Eigen::RowVector3d(5, 0, 0);
  for (std::vector<int> face : b.faces) {
    for (int& v : face) v += static_cast<int>(a.vertices.rows());
    cage.faces.push_back(face);
  }
  return cage;
}

/// Some faces carry no surface.
inline Cage with_holes(Cage cage, std::vector<int> holes) {
  cage.holes = std::move(holes);
  return cage;
}

/// Cages whose boundary has corners and regular vertices only, where the limit is the standard surface.
inline std::map<std::string, Cage> tame_open_cages() {
  return {{"sheet", sheet(3, 4)},
          {"quad", sheet(1, 1)},
          {"strip, corners adjacent", sheet(1, 5)},
          {"tube", tube(5, 3)},
          {"loops one edge apart", tube(4, 1)},
          {"triangular loops", tube(3, 1)},
          {"disc of 3", disc(3)},
          {"disc of 7", disc(7)},
          {"triangle", polygon(3)},
          {"hexagon", polygon(6)},
          {"open cube", without(cube(), {0})},
          {"two components", joined(disc(5), tube(6, 2))},
          {"one open", joined(cube(), disc(3))},
          {"open prism", without(prism(5), {0})}};
}

/// Cages with a vertex of three faces or more on the boundary.
inline std::map<std::string, Cage> wild_open_cages() {
  std::map<std::string, Cage> cages{{"L", without(sheet(4, 4), {0, 1, 4, 5})},
                                    {"hole in a sheet", without(sheet(5, 5), {12})},
                                    {"two holes one edge apart", without(sheet(7, 5), {16, 18})},
                                    {"open trapezohedron", without(trapezohedron(6), {0})},
                                    {"triangles", without(tetrahedron(), {0})},
                                    {"wedge and sheet", joined(half_disc(4), sheet(2, 2))}};
  for (int k = 3; k <= 8; ++k) cages.emplace("fan of " + std::to_string(k), half_disc(k));
  return cages;
}

/// Cages whose holes give every boundary vertex its whole fan.
inline std::map<std::string, Cage> holed_cages() {
  return {{"cube without a side", with_holes(cube(), {2})},
          {"cube without two opposite sides", with_holes(cube(), {0, 1})},
          {"prism without an end", with_holes(prism(5), {0})},
          {"trapezohedron without a face", with_holes(trapezohedron(5), {3})},
          {"sheet within a sheet", with_holes(sheet(4, 4), {0, 1, 2, 3, 4, 7, 8, 11, 12, 13, 14, 15})}};
}

}  // namespace umbilic::test
