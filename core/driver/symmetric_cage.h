// SPDX-License-Identifier: MIT
/// \file
/// Refined symmetric surfaces as the control points of one vertex of each orbit, which is how minimizers are kept.
#pragma once

#include <optional>

#include "cage/cage.h"
#include "mesh/symmetry.h"

namespace umbilic {

/// A control mesh so many Catmull-Clark steps from a cage, and the symmetry that it inherits, where that is known.
struct SymmetricCage {
  Cage cage;
  std::optional<SymmetryGroup> symmetry;
  int level = 0;
};

/// The control mesh `level` >= 0 Catmull-Clark steps from `cage` that these points describe: those of the first vertex
/// of each orbit, of a run that keeps the symmetry of `cage`, which is that of the mesh then; or those of all vertices,
/// of a run that keeps none, where the mesh may have any symmetry. `Run::orbit_points` gives either. Errors name the
/// number of points that it takes, or a point that is not finite; fails as `Run::create` otherwise.
Result<SymmetricCage> symmetric_cage(const Cage& cage, int level, const Points& orbit_points);

}  // namespace umbilic
