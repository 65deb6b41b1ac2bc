// SPDX-License-Identifier: MIT
/// \file
/// The surface of a run with other targets for its constraints.
#pragma once

#include "driver/surface.h"
#include "problem/targets.h"

namespace umbilic {

/// `surface`, refined from `cage` at level 0, with the pins and the pull that `targets` give; `changed` are the
/// constraints after set_targets. Its control points stay: they no longer fulfil the equations. Fails where the
/// targets contradict one another or do not keep the symmetry of `cage`, and as `hold` (driver/pin_rows.h).
Result<RefinedCage> with_targets(RefinedCage surface, const RefinedCage& cage, const Targets& targets,
                                 const Constraints& changed, CapKind cap);

}  // namespace umbilic
