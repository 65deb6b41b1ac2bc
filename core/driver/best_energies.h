// SPDX-License-Identifier: MIT
/// \file
/// The energies of a run's best surface: computed when they are asked for, and kept while the surface stays.
#pragma once

#include <optional>

#include "cage/cage.h"
#include "driver/level.h"
#include "problem/energy_report.h"
#include "surface/cap_kind.h"

namespace umbilic {

/// The control mesh of a level's best surface, in the cage's own coordinates.
Cage control_mesh(const Level& level);

/// Each member is asked with the level that has the surface, and, between two calls of `forget`, always with the same.
class BestEnergies {
 public:
  /// The surface has changed.
  void forget() { *this = {}; }
  /// The surface has become another one, whose energies are known.
  void become(const EnergyReport& known);

  /// Of the surface as the level has it.
  const EnergyReport& exact(const Level& level);
  /// Of the surface as it is written: that of `control_mesh`, whose coordinates are rounded to where the cage lies.
  const EnergyReport& written(const Level& level, CapChoice cap);
  /// Kept for the faces that it was asked for last.
  const OpinionReport& second_opinion(const Level& level, CapChoice cap, OpinionFaces faces);

 private:
  std::optional<EnergyReport> exact_;
  std::optional<EnergyReport> written_;  // if that is another surface
  std::optional<OpinionReport> opinion_;
  OpinionFaces opinion_faces_ = OpinionFaces::kAll;
};

}  // namespace umbilic
