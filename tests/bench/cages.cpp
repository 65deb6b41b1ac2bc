// SPDX-License-Identifier: MIT
/// \file
/// Pushes a cube, moves the points of a frame.
#include "cages.h"

#include <cmath>
#include <random>

#include "cage/generate.h"
#include "mesh/subdivision.h"

namespace umbilic {
namespace {

Cage pushed_cube() {
  const Cage cube = *generate_cage("cube");
  const Refinement once = catmull_clark(PolygonMesh(cube));
  const Refinement twice = catmull_clark(once.mesh);
  const Points points = twice.stencil * (once.stencil * cube.vertices).eval();
  Cage result{points, std::vector<std::vector<int>>(twice.mesh.face_count())};
  const double extent = points.cwiseAbs().maxCoeff();
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const Vector3 p = points.row(v).transpose() / extent;
    const Vector3 push{std::sin(3 * p.y() + 1), std::sin(2 * p.z() + 0.5), std::cos(2.5 * p.x() - 0.3)};
    result.vertices.row(v) += 0.3 * extent * push.transpose();
  }
  for (int f = 0; f < twice.mesh.face_count(); ++f) {
    for (int i = 0; i < twice.mesh.face_size(f); ++i) {
      result.faces[f].push_back(twice.mesh.origin(twice.mesh.halfedge(f, i)));
    }
  }
  return result;
}

Cage moved(Cage cage) {
  std::mt19937 random(1);
  for (double& x : cage.vertices.reshaped()) x += 0.12 * (2.0 * random() / std::mt19937::max() - 1);
  return cage;
}

}  // namespace

Result<Cage> bench_cage(std::string_view name) {
  if (name == "pushed-cube") return pushed_cube();
  if (name == "moved-two-3") return moved(*generate_cage("two-3"));
  return generate_cage(name);
}

}  // namespace umbilic
