// SPDX-License-Identifier: MIT
/// \file
/// The generators, and the list.
#include "stress/cages.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "cage/generate.h"
#include "mesh/rough_cages.h"

namespace umbilic::test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Cage scaled(Cage cage, double x, double y, double z) {
  cage.vertices = (cage.vertices * Vector3(x, y, z).asDiagonal()).eval();
  return cage;
}

Cage moved(Cage cage, double x, double y, double z) {
  cage.vertices.rowwise() += Eigen::RowVector3d(x, y, z);
  return cage;
}

/// With vertex `v` at `position`.
Cage with_vertex(Cage cage, int v, Vector3 position) {
  cage.vertices.row(v) = position.transpose();
  return cage;
}

Cage with_swapped(Cage cage, int a, int b) {
  cage.vertices.row(a).swap(cage.vertices.row(b));
  return cage;
}

/// Each plane of constant z turned about the z axis, by `angle` per unit.
Cage twisted(Cage cage, double angle) {
  for (Eigen::Index v = 0; v < cage.vertices.rows(); ++v) {
    const Eigen::AngleAxisd turn(angle * cage.vertices(v, 2), Vector3::UnitZ());
    cage.vertices.row(v) = (turn * Vector3(cage.vertices.row(v).transpose())).transpose();
  }
  return cage;
}

Cage both(const Cage& a, const Cage& b) {
  Cage all{Points(a.vertices.rows() + b.vertices.rows(), 3), a.faces};
  all.vertices << a.vertices, b.vertices;
  for (std::vector<int> face : b.faces) {
    for (int& corner : face) corner += static_cast<int>(a.vertices.rows());
    all.faces.push_back(face);
  }
  return all;
}

/// A prism over a star with n points.
Cage star(int n, double inner) {
  Cage cage = prism(2 * n);
  for (int v = 0; v < 4 * n; v += 2) cage.vertices.row(v).head<2>() *= inner;
  return cage;
}

/// Császár's polyhedron: a torus of 7 vertices without a diagonal.
Cage csaszar() {
  Cage cage{Points(7, 3), {}};
  cage.vertices << 3, -3, 0, -3, 3, 0, -3, -3, 1, 3, 3, 1, -1, -2, 3, 1, 2, 3, 0, 0, 15;
  for (int i = 0; i < 7; ++i) {  // Möbius' triangulation
    cage.faces.push_back({i, (i + 1) % 7, (i + 3) % 7});
    cage.faces.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return cage;
}

Cage generated(const char* name, const CageOptions& options = {}) { return *generate_cage(name, options); }

std::vector<StressCage> make() {
  const Cage frame = generated("two-3"), small_torus = wound_torus(6, 4, 0.5, 1);
  Cage flat = box(2, 2, 0);
  flat.vertices.topRows(4) *= 0.9;  // so that no two points coincide
  std::vector<StressCage> list{
      {"needle 1 : 100", bipyramid(8, 100)},
      {"needle 1 : 1000", box(1, 1, 1000)},
      {"lens 1 : 100", bipyramid(8, 0.01)},
      {"lens 1 : 1000", bipyramid(5, 0.001)},
      {"plate 1 : 333", box(2, 2, 0.006)},
      {"plate 1 : 1e6", box(2, 2, 2e-6)},
      {"box 1000 : 1 : 1", box(1000, 1, 1)},
      {"box 1000 : 1 : 0.001", box(1000, 1, 0.001)},
      {"box 30 : 30 : 1", box(30, 30, 1)},
      {"flat box", flat},
      {"flat tetrahedron", scaled(tetrahedron(), 1, 1, 1e-3)},
      {"tiny tetrahedron", scaled(tetrahedron(), 1e-6, 1e-6, 1e-6)},
      {"tetrahedron", tetrahedron()},
      {"noise 0.3 on a cube", noisy(cube(), 0.6, 1)},
      {"noise 1 on a cube", noisy(cube(), 2, 2)},
      {"noise 2 on a cube", noisy(cube(), 4, 3)},
      {"noise 0.3 on a torus", noisy(small_torus, 0.15, 4)},
      {"noise 1 on a torus", noisy(small_torus, 0.5, 5)},
      {"noise 0.1 on a frame", noisy(frame, 0.05, 6)},
      {"noise 0.3 on a frame", noisy(frame, 0.15, 7)},
      {"noise 1 on a frame", noisy(frame, 0.5, 8)},
      {"double sphere", wound_sphere(6, 2, 2)},
      {"triple sphere", wound_sphere(9, 2, 3)},
      {"double cover of a torus", wound_torus(5, 8, 0.5, 2)},
      {"triple cover of a torus", wound_torus(4, 9, 0.4, 3)},
      {"spike", with_vertex(cube(), 6, Vector3(1e4, 1e4, 1e4))},
      {"folded cube", with_vertex(cube(), 6, Vector3(-3, -3, -3))},
      {"cube with a vertex in the middle", with_vertex(cube(), 6, Vector3(0, 0, 0))},
      {"cube with swapped vertices", with_swapped(cube(), 0, 6)},
      {"cube with a crossed face", with_swapped(cube(), 4, 5)},
      {"twisted tower", twisted(box(1, 1, 8), 0.7)},
      {"twisted frame", twisted(frame, 2)},
      {"thin torus 1 : 100", wound_torus(8, 4, 0.01, 1)},
      {"thin torus 1 : 1000", wound_torus(8, 4, 0.001, 1)},
      {"fat torus", wound_torus(6, 6, 0.99, 1)},
      {"spindle torus", wound_torus(6, 6, 1.5, 1)},
      {"valence 24", bipyramid(24, 0.5)},
      {"star", star(5, 0.05)},
      {"Csaszar's polyhedron", csaszar()},
      {"long frame", scaled(frame, 1, 1, 100)},
      {"flat frame", scaled(frame, 1, 1, 0.01)},
      {"two cubes", both(cube(), moved(cube(), 2.5, 0, 0))},
      {"two cubes through each other", both(cube(), moved(cube(), 0.5, 0.4, 0.3))},
      {"cube and plate", both(cube(), moved(box(2, 2, 0.006), 0, 0, 3))},
  };
  for (StressCage& entry : list) {
    const bool valid = validate(entry.cage).ok();
    assert(valid);
    static_cast<void>(valid);
  }
  return list;
}

}  // namespace

Cage box(double x, double y, double z) { return scaled(cube(), x / 2, y / 2, z / 2); }

Cage bipyramid(int n, double height) {
  Cage cage{Points(n + 2, 3), {}};
  for (int i = 0; i < n; ++i) {
    cage.vertices.row(i) << std::cos(kTurn * i / n), std::sin(kTurn * i / n), 0;
    cage.faces.push_back({i, (i + 1) % n, n});
    cage.faces.push_back({(i + 1) % n, i, n + 1});
  }
  cage.vertices.row(n) << 0, 0, height;
  cage.vertices.row(n + 1) << 0, 0, -height;
  return cage;
}

Cage wound_sphere(int segments, int rings, int windings) {
  Cage cage{Points(segments * rings + 2, 3), {}};
  const int north = segments * rings, south = north + 1;
  const auto at = [&](int ring, int segment) { return ring * segments + segment % segments; };
  for (int r = 0; r < rings; ++r) {
    const double latitude = kTurn / 2 * (r + 1) / (rings + 1);
    for (int s = 0; s < segments; ++s) {
      const double longitude = kTurn * windings * s / segments;
      cage.vertices.row(at(r, s)) << std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude),
          std::cos(latitude);
      if (r > 0) cage.faces.push_back({at(r - 1, s), at(r, s), at(r, s + 1), at(r - 1, s + 1)});
    }
  }
  cage.vertices.row(north) << 0, 0, 1;
  cage.vertices.row(south) << 0, 0, -1;
  for (int s = 0; s < segments; ++s) {
    cage.faces.push_back({north, at(0, s), at(0, s + 1)});
    cage.faces.push_back({south, at(rings - 1, s + 1), at(rings - 1, s)});
  }
  return cage;
}

Cage wound_torus(int major, int minor, double ratio, int windings) {
  Cage cage{Points(major * minor, 3), {}};
  const auto at = [&](int i, int j) { return i % major * minor + j % minor; };
  for (int i = 0; i < major; ++i) {
    for (int j = 0; j < minor; ++j) {
      const double around = kTurn * i / major, tube = kTurn * windings * j / minor;
      const double distance = 1 + ratio * std::cos(tube);
      cage.vertices.row(at(i, j)) << distance * std::cos(around), distance * std::sin(around), ratio * std::sin(tube);
      cage.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return cage;
}

Cage noisy(Cage cage, double amount, unsigned seed) {
  cage.vertices += amount * Random(seed).points(cage.vertices.rows());
  return cage;
}

const std::vector<StressCage>& stress_cages() {
  static const std::vector<StressCage> list = make();
  return list;
}

const Cage& stress_cage(const std::string& name) {
  const auto& list = stress_cages();
  const auto found = std::find_if(list.begin(), list.end(), [&](const StressCage& s) { return s.name == name; });
  assert(found != list.end());
  return found->cage;
}

}  // namespace umbilic::test
