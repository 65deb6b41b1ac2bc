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

/// The pins on the cage, with their copies.
Result<std::vector<HeldPoint>> held_on(const RefinedCage& cage, const Constraints& constraints) {
  RefinedCage own = cage;
  own.control = cage.own;
  Result<std::vector<HeldPoint>> held = hold(constraints.pins, own);
  if (!held || !constraints.symmetric) return held;
  return with_images(*held, elements_of(cage.symmetry, cage.mesh), cage.symmetry.center, cage.mesh);
}

/// The cage's symmetry is then the part of it that is kept.
std::optional<Error> move_pins(RefinedCage& cage, const Constraints& constraints, RefinedCage& surface) {
  const Result<std::vector<HeldPoint>> held = held_on(cage, constraints);
  if (!held) return held.error();
  if (held->size() != surface.pins.size()) {
    return Error{"pins: constraints.symmetric makes other copies of them than before; that takes a new run"};
  }
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
                                 const Constraints& changed, CapChoice cap) {
  SymmetryGroup before = cage.symmetry;
  if (!targets.pins.empty()) {
    if (auto error = move_pins(cage, changed, surface)) return *error;
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
