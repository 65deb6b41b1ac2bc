// SPDX-License-Identifier: MIT
/// \file
/// How a run minimizes, as the user asks for it.
#pragma once

#include "energy/functional.h"
#include "problem/metric_choice.h"
#include "surface/cap_kind.h"

namespace umbilic {

struct RunOptions {
  Weights weights{};
  CapKind cap = CapKind::kSmooth;
  int first_level = 0;        ///< >= 0, Catmull-Clark steps from the cage to the first mesh whose points are moved
  int last_level = 2;         ///< >= first_level; limits: see Run::create
  int max_iterations = 1000;  ///< >= 0, per level
  double tolerance = 1e-6;    ///< >= 0: see StopReason::kConverged
  bool symmetry = true;       ///< whether the surface keeps the cage's symmetry
  MetricChoice metric = MetricChoice::kAutomatic;
};

/// Whether all of them are in their ranges; otherwise `error` says which is not.
bool in_range(const RunOptions& options, Error& error);

}  // namespace umbilic
