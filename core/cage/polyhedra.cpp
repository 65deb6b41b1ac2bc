// SPDX-License-Identifier: MIT
/// \file
/// Coordinates of uniform polyhedra about the origin.
#include "cage/polyhedra.h"

#include <array>
#include <cmath>
#include <numbers>

namespace umbilic {

namespace {

constexpr std::array<double, 2> kSigns{1, -1};

std::vector<Vector3> tetrahedron() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

std::vector<Vector3> cube_vertices() {
  std::vector<Vector3> vertices;
  for (const double z : kSigns) {
    for (const double y : kSigns) {
      for (const double x : kSigns) vertices.emplace_back(x, y, z);
    }
  }
  return vertices;
}

std::vector<Vector3> octahedron() {
  std::vector<Vector3> vertices;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : kSigns) vertices.push_back(sign * Vector3::Unit(axis));
  }
  return vertices;
}

/// With square sides: all edges have length 1.
std::vector<Vector3> prism(int sides) {
  const double step = 2 * std::numbers::pi / sides, radius = 0.5 / std::sin(step / 2);
  std::vector<Vector3> vertices;
  for (const double z : {0.5, -0.5}) {
    for (int i = 0; i < sides; ++i) vertices.emplace_back(radius * std::cos(step * i), radius * std::sin(step * i), z);
  }
  return vertices;
}

/// The permutations of (0, ±1, ±1).
std::vector<Vector3> cuboctahedron() {
  std::vector<Vector3> vertices;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : kSigns) {
      for (const double b : kSigns)
        vertices.push_back(a * Vector3::Unit((axis + 1) % 3) + b * Vector3::Unit((axis + 2) % 3));
    }
  }
  return vertices;
}

/// The even permutations of (0, ±1, ±phi), phi the golden ratio.
std::vector<Vector3> icosahedron() {
  const double phi = (1 + std::sqrt(5.)) / 2;
  std::vector<Vector3> vertices;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : kSigns) {
      for (const double b : kSigns)
        vertices.push_back(a * Vector3::Unit((axis + 1) % 3) + b * phi * Vector3::Unit((axis + 2) % 3));
    }
  }
  return vertices;
}

/// The permutations of (3, 1, 1) with an even number of signs.
std::vector<Vector3> truncated_tetrahedron() {
  std::vector<Vector3> vertices;
  for (const Vector3& corner : tetrahedron()) {
    for (int axis = 0; axis < 3; ++axis) {
      Vector3 vertex = corner;
      vertex[axis] *= 3;
      vertices.push_back(vertex);
    }
  }
  return vertices;
}

/// A cube's vertices and the even permutations of (0, ±phi, ±1/phi), phi the golden ratio.
std::vector<Vector3> dodecahedron() {
  const double phi = (1 + std::sqrt(5.)) / 2;
  std::vector<Vector3> vertices = cube_vertices();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : kSigns) {
      for (const double b : kSigns)
        vertices.push_back(a * phi * Vector3::Unit((axis + 1) % 3) + b / phi * Vector3::Unit((axis + 2) % 3));
    }
  }
  return vertices;
}

}  // namespace

const std::vector<Polyhedron>& polyhedra() {
  static const std::vector<Polyhedron> all{
      {"tetrahedron-frame", "a tetrahedron", 4, 6, tetrahedron},
      {"cube-frame", "a cube", 8, 12, cube_vertices},
      {"octahedron-frame", "an octahedron", 6, 12, octahedron},
      {"triangular-prism-frame", "a triangular prism", 6, 9, [] { return prism(3); }},
      {"pentagonal-prism-frame", "a pentagonal prism", 10, 15, [] { return prism(5); }},
      {"hexagonal-prism-frame", "a hexagonal prism", 12, 18, [] { return prism(6); }},
      {"truncated-tetrahedron-frame", "a truncated tetrahedron", 12, 18, truncated_tetrahedron},
      {"dodecahedron-frame", "a dodecahedron", 20, 30, dodecahedron},
      {"cuboctahedron-frame", "a cuboctahedron", 12, 24, cuboctahedron},
      {"icosahedron-frame", "an icosahedron", 12, 30, icosahedron},
  };
  return all;
}

}  // namespace umbilic
