// SPDX-License-Identifier: MIT
/// \file
/// Solves for multipliers, and sums them along loops.
#include "driver/balance.h"

#include <Eigen/Geometry>

#include "driver/equations.h"
#include "surface/limit_stencil.h"

namespace umbilic {
namespace {

/// The gradient of what is minimized by all control points, held or not: a symmetric surface's is the projection of
/// that of its representative patches.
Points full_gradient(const Surface& surface, const Points& control) {
  Points gradient;
  surface.energy().evaluate(control, &gradient);
  if (surface.closeness()) surface.closeness()->evaluate(control, &gradient);
  if (surface.symmetry().generators.empty()) return gradient;
  const Coordinates symmetric(surface.mesh(), surface.symmetry());
  const Points center = symmetric.control(Eigen::VectorXd::Zero(symmetric.count()));
  return symmetric.control(symmetric.pull_back(gradient)) - center;
}

/// The loop of each vertex, -1 for those inside.
std::vector<int> loops_of_vertices(const std::vector<std::vector<int>>& loops, const PolygonMesh& mesh) {
  std::vector<int> result(mesh.vertex_count(), -1);
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    for (const int h : loops[loop]) result[mesh.origin(h)] = static_cast<int>(loop);
  }
  return result;
}

Vector3 center_of(const std::vector<int>& loop, const RefinedCage& cage) {
  std::vector<SurfacePlace> places;
  for (const int h : loop) places.push_back({.vertex = cage.mesh.origin(h)});
  Vector3 sum = Vector3::Zero();
  for (const LimitStencil& stencil : limit_stencils(cage.mesh, places)) sum += stencil.apply(cage.own).col(0);
  return sum / static_cast<double>(loop.size());
}

}  // namespace

Balance balance_of(const Surface& surface, const Points& control) {
  const RefinedCage& cage = surface.cage();
  Balance result{equations_of(cage), {}, {}, full_gradient(surface, control)};
  const int count = result.rows.rows.count();
  result.multipliers = Eigen::VectorXd::Zero(count);
  if (count == 0) return result;
  const Coordinates coordinates(cage.mesh, {}, held_points(cage, surface.layout().cap()));
  const AffineSubspace solutions(in_coordinates(result.rows.rows, coordinates), coordinates.unknowns(control));
  if (!solutions.contradiction().empty()) return result;
  result.redundant = solutions.redundant();
  result.multipliers = solutions.multipliers(coordinates.pull_back(result.reactions));
  Eigen::Map<Eigen::VectorXd>(result.reactions.data(), result.reactions.size()) -=
      result.rows.rows.matrix.transpose() * result.multipliers;
  return result;
}

std::vector<LoopPull> loop_pulls(const Balance& balance, const RefinedCage& cage) {
  const std::vector<std::vector<int>> loops = numbered_loops(cage.mesh);
  const std::vector<int> loop_of = loops_of_vertices(loops, cage.mesh);
  std::vector<LoopPull> pulls(loops.size());
  std::vector<bool> held(loops.size(), false);
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    pulls[loop].loop = static_cast<int>(loop);
    pulls[loop].center = center_of(loops[loop], cage);
  }
  std::vector<Vector3> forces(cage.mesh.vertex_count(), Vector3::Zero());
  const LinearRows& rows = balance.rows.rows;
  for (int row = 0; row < rows.count(); ++row) {
    const PinRow& owner = balance.rows.owners[row];
    if (owner.pin >= 0) continue;
    double weights = 0;
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(rows.matrix, row); it; ++it)
      weights += it.value();
    LoopPull& pull = pulls[loop_of[owner.vertex]];
    held[loop_of[owner.vertex]] = true;
    const Vector3 multiplier = balance.multipliers[row] * Vector3::Unit(owner.coordinate);
    forces[owner.vertex] += weights * multiplier;
    // The equations of x, y and z follow one another. What turns is their vector without the centre's part.
    const Vector3 turned = rows.right.segment<3>(row - owner.coordinate) - weights * pull.center;
    pull.moment += turned.cross(multiplier);
  }
  std::vector<LoopPull> result;
  for (std::size_t loop = 0; loop < loops.size(); ++loop) {
    if (!held[loop]) continue;
    for (const int h : loops[loop]) {
      const Vector3& force = forces[cage.mesh.origin(h)];
      pulls[loop].force += force;
      pulls[loop].total += force.norm();
    }
    result.push_back(pulls[loop]);
  }
  return result;
}

}  // namespace umbilic
