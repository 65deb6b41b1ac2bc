// SPDX-License-Identifier: MIT
/// \file
/// Moves pins, whose places stay.
#include "driver/retarget.h"

#include <cmath>
#include <utility>

#include "driver/equations.h"
#include "driver/pin_rows.h"
#include "mesh/subgroup.h"

namespace umbilic {
namespace {

/// The part of the cage's symmetry that maps the pins with what they hold to one another.
SymmetryGroup kept_symmetry(const std::vector<HeldPoint>& pins, const RefinedCage& cage) {
  return subgroup(cage.symmetry, cage.mesh,
                  [&](const Symmetry& element) { return keeps(element, cage.symmetry.center, pins, cage.mesh); });
}

/// The cage's symmetry is then the part of it that is kept.
std::optional<Error> move_pins(RefinedCage& cage, const std::vector<Pin>& pins, RefinedCage& surface) {
  RefinedCage own = cage;
  own.control = cage.own;
  const Result<std::vector<HeldPoint>> held = hold(pins, own);
  if (!held) return held.error();
  SymmetryGroup kept = kept_symmetry(*held, cage);
  if (kept.order < cage.symmetry.order) {
    cage.symmetry = std::move(kept);
    surface.symmetry = refine(cage, surface.level).symmetry;
  }
  for (std::size_t i = 0; i < surface.pins.size(); ++i) {
    surface.pins[i].position = (*held)[i].position;
    surface.pins[i].normal = (*held)[i].normal;
  }
  return std::nullopt;
}

}  // namespace

Result<RefinedCage> with_targets(RefinedCage surface, RefinedCage& cage, const Targets& targets,
                                 const Constraints& changed, CapKind cap) {
  SymmetryGroup before = cage.symmetry;
  if (!targets.pins.empty()) {
    if (changed.symmetric) return Error{"pins: those that constraints.symmetric copies cannot move under a run"};
    if (auto error = move_pins(cage, changed.pins, surface)) return *error;
    const Coordinates coordinates(surface.mesh, surface.symmetry, held_points(surface, cap));
    if (auto error = contradiction_of(surface, coordinates)) {
      cage.symmetry = std::move(before);
      return *error;
    }
  }
  if (targets.closeness) surface.closeness = std::ldexp(*targets.closeness, 4 * cage.placement.exponent);
  return surface;
}

}  // namespace umbilic
