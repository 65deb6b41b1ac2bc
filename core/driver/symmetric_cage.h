// SPDX-License-Identifier: MIT
/// \file
/// Refined symmetric surfaces, represented by the control points of one vertex of each orbit. Minimizers are stored in
/// this form.
#pragma once

#include <optional>

#include "cage/cage.h"
#include "mesh/symmetry.h"

namespace umbilic {

/// A control mesh `level` Catmull-Clark steps from a cage, with the symmetry that it inherits if that is known.
struct SymmetricCage {
  Cage cage;
  std::optional<SymmetryGroup> symmetry;
  int level = 0;
};

/// The control mesh `level` >= 0 Catmull-Clark steps from `cage` with these points, which may be of two kinds: those of
/// the first vertex of each orbit, if the run kept the symmetry of `cage`, which the mesh then has; or those of all
/// vertices, if the run kept none. `Run::orbit_points` gives either. Errors name the expected number of points, or a
/// point that is not finite; otherwise fails as `Run::create`.
Result<SymmetricCage> symmetric_cage(const Cage& cage, int level, const Points& orbit_points);

}  // namespace umbilic
