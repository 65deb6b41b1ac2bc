// SPDX-License-Identifier: MIT
/// \file
/// Refined symmetric surfaces as the control points of one vertex of each orbit, which is how minimizers are kept.
#pragma once

#include "cage/cage.h"
#include "mesh/symmetry.h"

namespace umbilic {

/// A cage whose symmetry need not be searched for.
struct SymmetricCage {
  Cage cage;
  SymmetryGroup symmetry;
};

/// The control mesh `level` >= 0 Catmull-Clark steps from `cage`, with the symmetry of `cage`, where the first vertices
/// of its orbits have these points: what `Run::orbit_points` gives of a run on `cage` that keeps its symmetry. Errors
/// name the number of points that it takes, or a point that is not finite; fails as `Run::create` otherwise.
Result<SymmetricCage> symmetric_cage(const Cage& cage, int level, const Points& orbit_points);

}  // namespace umbilic
