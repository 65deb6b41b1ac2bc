// SPDX-License-Identifier: MIT
/// \file
/// Pushes a cube and an icosahedron, moves the points of frames.
#include "cages.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "cage/generate.h"
#include "mesh/subdivision.h"

namespace umbilic {
namespace {

/// The cage after some Catmull-Clark steps, as a cage of its own.
Cage refined(const Cage& cage, int steps) {
  PolygonMesh mesh(cage);
  Points points = cage.vertices;
  for (int step = 0; step < steps; ++step) {
    Refinement finer = catmull_clark(mesh);
    points = Points(finer.stencil * points);
    mesh = std::move(finer.mesh);
  }
  Cage result{points, std::vector<std::vector<int>>(mesh.face_count())};
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < mesh.face_size(f); ++i) result.faces[f].push_back(mesh.origin(mesh.halfedge(f, i)));
  }
  return result;
}

Cage icosahedron() {
  const double phi = (1 + std::sqrt(5.)) / 2;
  Cage cage{Points(12, 3), {}};
  for (int axis = 0, v = 0; axis < 3; ++axis) {
    for (const double a : {1., -1.}) {
      for (const double b : {1., -1.}) {
        cage.vertices.row(v++) =
            (a * Vector3::Unit((axis + 1) % 3) + b * phi * Vector3::Unit((axis + 2) % 3)).transpose();
      }
    }
  }
  const auto at = [&](int v) { return Vector3(cage.vertices.row(v).transpose()); };
  const auto joined = [&](int a, int b) { return std::abs((at(a) - at(b)).norm() - 2) < 1e-6; };
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        if (!joined(a, b) || !joined(b, c) || !joined(a, c)) continue;
        const bool outwards = at(a).dot(at(b).cross(at(c))) > 0;
        cage.faces.push_back(outwards ? std::vector{a, b, c} : std::vector{a, c, b});
      }
    }
  }
  return cage;
}

/// Pushed smoothly out of all symmetry.
Cage pushed(Cage cage) {
  const double extent = cage.vertices.cwiseAbs().maxCoeff();
  const Points points = cage.vertices;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const Vector3 p = points.row(v).transpose() / extent;
    const Vector3 push{std::sin(3 * p.y() + 1), std::sin(2 * p.z() + 0.5), std::cos(2.5 * p.x() - 0.3)};
    cage.vertices.row(v) += 0.3 * extent * push.transpose();
  }
  return cage;
}

Cage moved(Cage cage, unsigned seed) {
  std::mt19937 random(seed);
  for (double& x : cage.vertices.reshaped()) x += 0.12 * (2.0 * random() / std::mt19937::max() - 1);
  return cage;
}

}  // namespace

Result<Cage> bench_cage(std::string_view name) {
  if (name == "pushed-cube") return pushed(refined(*generate_cage("cube"), 2));
  if (name == "animal") return pushed(refined(icosahedron(), 2));
  constexpr std::string_view kMoved = "moved-";
  if (!name.starts_with(kMoved)) return generate_cage(name);
  name.remove_prefix(kMoved.size());
  unsigned seed = 1;
  if (const std::size_t at = name.find(':'); at != name.npos) {
    seed = static_cast<unsigned>(std::stoul(std::string(name.substr(at + 1))));
    name = name.substr(0, at);
  }
  Result<Cage> cage = generate_cage(name);
  if (!cage) return cage;
  return moved(std::move(cage).value(), seed);
}

}  // namespace umbilic
