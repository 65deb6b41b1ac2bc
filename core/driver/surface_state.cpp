// SPDX-License-Identifier: MIT
/// \file
/// Refines the connectivity and the symmetry of a cage, and places its points.
#include "driver/surface_state.h"

#include <fmt/format.h>

#include <utility>

#include "mesh/coordinates.h"
#include "mesh/subdivision.h"

namespace umbilic {
namespace {

/// What `refine` does, without the control points, which nobody asks for.
RefinedCage refine_connectivity(RefinedCage cage, int steps) {
  if (cage.is_constrained()) return refine(std::move(cage), steps);
  for (; steps > 0; --steps) {
    cage.symmetry = refined(cage.symmetry, cage.mesh);
    cage.mesh = catmull_clark_mesh(cage.mesh);
    ++cage.level;
  }
  return cage;
}

}  // namespace

Result<RefinedCage> at_state(RefinedCage cage, const SurfaceState& state, CapChoice cap, bool symmetric) {
  RefinedCage result = refine_connectivity(std::move(cage), state.level);
  const Points& points = state.points;
  const int vertices = result.mesh.vertex_count();
  const int orbits = Coordinates(result.mesh, result.symmetry).orbit_count();
  const bool all = points.rows() == vertices;
  if (points.rows() != orbits && !all) {
    return Error{
        fmt::format("{} points: expected {}, one for each orbit of vertices at level {}, or {}, of all vertices",
                    points.rows(), orbits, state.level, vertices)};
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) return Error{fmt::format("point {} is not finite", i + 1)};
  }
  const Points unit = result.placement.to_unit(points);
  if (all && orbits < vertices) {
    result.symmetry = {};
    if (symmetric && !result.is_constrained()) result.symmetry = find_symmetry(result.mesh, unit);
    const Coordinates coordinates(result.mesh, result.symmetry, held_points(result, cap));
    result.control = coordinates.control(coordinates.unknowns(unit));
  } else {
    const Coordinates coordinates(result.mesh, result.symmetry, held_points(result, cap));
    result.control = coordinates.control_from_orbits(unit);
  }
  return result;
}

}  // namespace umbilic
