// SPDX-License-Identifier: MIT
/// \file
/// The surface of a run with other targets for its constraints.
#pragma once

#include "driver/surface.h"
#include "problem/targets.h"

namespace umbilic {

/// `surface`, refined from `cage` at level 0, with the pins and the pull that `targets` give; `changed` are the
/// constraints after set_targets. Its control points stay: they no longer fulfil the equations. Both keep that part of
/// their symmetry which the targets have. Fails where the targets contradict one another, and as `hold`
/// (driver/pin_rows.h); `cage` then stays as it is.
Result<RefinedCage> with_targets(RefinedCage surface, RefinedCage& cage, const Targets& targets,
                                 const Constraints& changed, CapChoice cap);

}  // namespace umbilic
