// SPDX-License-Identifier: MIT
/// \file
/// Refines the connectivity and the symmetry of a cage, and places its points.
#include "driver/symmetric_cage.h"

#include <fmt/format.h>

#include <utility>

#include "driver/surface.h"
#include "mesh/coordinates.h"
#include "mesh/subdivision.h"

namespace umbilic {

Result<SymmetricCage> symmetric_cage(const Cage& cage, int level, const Points& orbit_points) {
  if (level < 0) return Error{fmt::format("level {}: expected a number >= 0", level)};
  Result<RefinedCage> prepared = prepare({cage, {}}, level, true);
  if (!prepared) return prepared.error();
  PolygonMesh mesh = std::move(prepared->mesh);
  SymmetryGroup symmetry = std::move(prepared->symmetry);
  for (int step = 0; step < level; ++step) {
    symmetry = refined(symmetry, mesh);
    mesh = catmull_clark_mesh(mesh);
  }
  const Placement& placement = prepared->placement;
  const Coordinates coordinates(mesh, symmetry);
  const bool all = orbit_points.rows() == mesh.vertex_count();
  if (orbit_points.rows() != coordinates.orbit_count() && !all) {
    return Error{
        fmt::format("{} points: expected {}, one for each orbit of vertices at level {}, or {}, of all vertices",
                    orbit_points.rows(), coordinates.orbit_count(), level, mesh.vertex_count())};
  }
  for (Eigen::Index i = 0; i < orbit_points.rows(); ++i) {
    if (!orbit_points.row(i).allFinite()) return Error{fmt::format("point {} is not finite", i + 1)};
  }
  if (all) return SymmetricCage{to_cage(mesh, orbit_points), std::nullopt, level};
  const Points control = coordinates.control_from_orbits(placement.to_unit(orbit_points));
  symmetry.center = placement.back(symmetry.center);
  return SymmetricCage{to_cage(mesh, placement.back(control)), std::move(symmetry), level};
}

}  // namespace umbilic
