// SPDX-License-Identifier: MIT
/// \file
/// Reports on a level's best surface.
#include "driver/best_energies.h"

#include "driver/run.h"
#include "driver/second_opinion.h"

namespace umbilic {

Cage control_mesh(const Level& level) {
  const RefinedCage refined = level.best_cage();
  return to_cage(refined.mesh, refined.placement.back(refined.control));
}

void BestEnergies::become(const EnergyReport& known) {
  forget();
  exact_ = known;
}

const EnergyReport& BestEnergies::exact(const Level& level) {
  if (!exact_) exact_ = level.surface().report(level.best());
  return *exact_;
}

const EnergyReport& BestEnergies::written(const Level& level, CapChoice cap) {
  const EnergyReport& found = exact(level);
  if (level.surface().placement().is_centred() || level.surface().mesh().is_open()) return found;
  if (!written_) {
    const Result<EvaluationReport> evaluation = evaluate(control_mesh(level), cap, 0);
    written_ = evaluation ? evaluation->energies : found;
    written_->quadrature_error = found.quadrature_error;
    written_->free = found.free;
    written_->closeness = found.closeness;
  }
  return *written_;
}

const OpinionReport& BestEnergies::second_opinion(const Level& level, CapChoice cap, OpinionFaces faces) {
  if (!opinion_ || opinion_faces_ != faces) {
    RefinedCage surface = level.surface().cage();
    surface.control = level.best();
    opinion_ = umbilic::second_opinion(surface, cap, exact(level), faces);
    opinion_faces_ = faces;
  }
  return *opinion_;
}

}  // namespace umbilic
