// SPDX-License-Identifier: MIT
/// \file
/// Closed polyhedra of any valence with randomly moved vertices, so that no symmetry hides an error.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "cage/cage.h"
#include "mesh/subdivision.h"

namespace umbilic::test {

/// Uniform in [-1, 1], the same on every platform.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return 2.0 * engine_() / std::mt19937::max() - 1; }

  template <class Matrix>
  Matrix matrix(Eigen::Index rows, Eigen::Index columns) {
    Matrix m(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index j = 0; j < columns; ++j) m(i, j) = (*this)();
    }
    return m;
  }
  Points points(Eigen::Index count) { return matrix<Points>(count, 3); }
  Vector3 vector() { return points(1).row(0).transpose(); }

 private:
  std::mt19937 engine_;
};

/// A rotation in general position.
inline Eigen::Matrix3d some_rotation() {
  return Eigen::AngleAxisd(1.1, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
}

inline Cage tetrahedron() {
  Cage cage{Points(4, 3), {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  cage.vertices << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  return cage;
}

inline Cage cube() {
  Cage cage{Points(8, 3), {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  cage.vertices << -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1;
  return cage;
}

/// Two n-gons and n quads.
inline Cage prism(int n) {
  Cage cage{Points(2 * n, 3), std::vector<std::vector<int>>(2)};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    cage.vertices.row(i) << std::cos(angle), std::sin(angle), 1;
    cage.vertices.row(n + i) << std::cos(angle), std::sin(angle), -1;
    cage.faces[0].push_back(i);
    cage.faces[1].push_back(2 * n - 1 - i);
    cage.faces.push_back({i, n + i, n + (i + 1) % n, (i + 1) % n});
  }
  return cage;
}

/// Two apexes of valence n and a zigzag of 2n vertices of valence 3 between them; 2n quads.
inline Cage trapezohedron(int n) {
  Cage cage{Points(2 * n + 2, 3), {}};
  cage.vertices.row(2 * n) << 0, 0, 1.2;
  cage.vertices.row(2 * n + 1) << 0, 0, -1.2;
  for (int i = 0; i < 2 * n; ++i) {
    const double angle = std::numbers::pi * i / n;
    cage.vertices.row(i) << std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.3 : -0.3;
    const int next = (i + 1) % (2 * n), second = (i + 2) % (2 * n);
    if (i % 2 == 0) {
      cage.faces.push_back({i, next, second, 2 * n});
    } else {
      cage.faces.push_back({second, next, i, 2 * n + 1});
    }
  }
  return cage;
}

struct Refined {
  PolygonMesh mesh;
  Points control;
};

inline Refined refined(const PolygonMesh& mesh, const Points& control, int steps) {
  Refined result{mesh, control};
  for (int i = 0; i < steps; ++i) {
    Refinement step = catmull_clark(result.mesh);
    result.control = (step.stencil * result.control).eval();
    result.mesh = std::move(step.mesh);
  }
  return result;
}

inline Refined refined(const Cage& cage, int steps) { return refined(PolygonMesh(cage), cage.vertices, steps); }

/// The refined cage with every control point moved by up to `amount` in each coordinate.
inline Refined rough(const Cage& cage, int steps, double amount, unsigned seed) {
  Refined result = refined(cage, steps);
  result.control += amount * Random(seed).points(result.control.rows());
  return result;
}

}  // namespace umbilic::test
