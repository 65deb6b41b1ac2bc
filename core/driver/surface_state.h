// SPDX-License-Identifier: MIT
/// \file
/// Surfaces of runs in compact form: the control points of one vertex of each orbit. Minimizers are stored in this
/// form.
#pragma once

#include "driver/surface.h"
#include "problem/problem.h"

namespace umbilic {

/// The control mesh of a state, refined from `cage` at level 0, with its symmetry and what is held there. The points
/// may be of two kinds: those of the first vertex of each orbit, if the run kept the symmetry of `cage`; or those of
/// all vertices, if the run kept none, in which case a symmetry of the mesh is searched for if `symmetric`.
/// `Run::orbit_points` gives either. Held points are taken from the cage. Errors name the expected number of points, or
/// a point that is not finite.
Result<RefinedCage> at_state(RefinedCage cage, const SurfaceState& state, CapChoice cap, bool symmetric);

}  // namespace umbilic
