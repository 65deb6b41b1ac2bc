// SPDX-License-Identifier: MIT
/// \file
/// The surface of a run with other targets for its constraints.
#pragma once

#include "cage/cage.h"
#include "driver/surface.h"
#include "problem/targets.h"

namespace umbilic {

struct Retargeted {
  RefinedCage cage;  ///< at level 0
  RefinedCage surface;
  /// Whether a new run from this cage would find no symmetry that the surface does not have.
  bool has_cages_symmetry = true;
};

/// `surface`, refined from `cage` at level 0, with the pins, the pull and what is held as `targets` have it; `changed`
/// are the constraints after set_targets, `own` is the run's cage with the targets' points. Both keep that part of
/// their symmetry which the targets have.
///
/// Where the points have moved, the cage is what a new run from `own` would begin with, but for its placement, which
/// stays, and for symmetry that it did not have before; and all that the surface takes from the cage's own surface is
/// refined from it as in a new run. A surface that takes nothing from it stays as it is.
///
/// The control points of the surface stay: they are no longer where points are held, nor fulfil the equations. Fails
/// where the targets contradict one another, where constraints.symmetric holds other elements than before, and as
/// `prepare` and `hold` (driver/pin_rows.h).
Result<Retargeted> with_targets(RefinedCage surface, RefinedCage cage, const Targets& targets,
                                const Constraints& changed, const Cage& own, CapChoice cap);

}  // namespace umbilic
