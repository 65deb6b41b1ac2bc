// SPDX-License-Identifier: MIT
/// \file
/// Runs that are asked for an accuracy instead of levels: how many they take, and how far each is minimized.
#pragma once

#include "driver/surface.h"
#include "problem/options.h"
#include "problem/report.h"

namespace umbilic {

/// The tolerance of each level. With an accuracy no level is minimized further than matters: it ends when the decrease
/// still predicted is a fiftieth of what may be left open.
double tolerance_of(const RunOptions& options);

/// Whether so many levels that could be evaluated tell the limit well enough, or seem to tell none.
bool suffice(int levels, const LimitReport& limit, double accuracy);

/// Sets the last level to the sixth that can be evaluated, or to the last that fits. `required` is the first that can
/// be evaluated (mesh/hierarchy.h), `started` that of the surface with which the run begins.
void choose_last_level(const RefinedCage& cage, int required, int started, RunOptions& options);

}  // namespace umbilic
