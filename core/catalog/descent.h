// SPDX-License-Identifier: MIT
/// \file
/// What a symmetric minimizer descends to once it may leave its symmetry.
#pragma once

#include <functional>
#include <optional>

#include "driver/problem_run.h"

namespace umbilic::catalog {

/// Called during a computation with the current run; returns whether to continue.
using Watch = std::function<bool(const Run&)>;

/// A surface that lies clearly below another one, at which a run along its directions of descent has ended.
struct LowerMinimizer {
  GroupReport group;
  LevelReport result;
  EnergyReport energies;
  std::optional<CertificateReport> certificate;
  Points orbit_points;  ///< see driver/surface_state.h
};

/// Minimizes `problem` from its start, which a certificate has found below a surface of this energy, and goes on along
/// further directions of descent while that gains at least kLeastDescent. `lower` is where this ends; nothing if
/// nothing is clearly lower. Returns false if `watch` ended it.
bool descend(Problem problem, double energy, const Watch& watch, std::optional<LowerMinimizer>& lower);

}  // namespace umbilic::catalog
