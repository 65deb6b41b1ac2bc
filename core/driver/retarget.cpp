// SPDX-License-Identifier: MIT
/// \file
/// Moves pins, whose places stay.
#include "driver/retarget.h"

#include <fmt/format.h>

#include <cmath>

#include "driver/equations.h"
#include "driver/pin_rows.h"
#include "mesh/subgroup.h"

namespace umbilic {
namespace {

bool keeps_symmetry(const std::vector<HeldPoint>& pins, const RefinedCage& cage) {
  const auto kept = [&](const Symmetry& element) { return keeps(element, cage.symmetry.center, pins, cage.mesh); };
  return subgroup(cage.symmetry, cage.mesh, kept).order == cage.symmetry.order;
}

std::optional<Error> move_pins(const RefinedCage& cage, const std::vector<Pin>& pins, RefinedCage& surface) {
  RefinedCage own = cage;
  own.control = cage.own;
  const Result<std::vector<HeldPoint>> held = hold(pins, own);
  if (!held) return held.error();
  if (!keeps_symmetry(*held, cage)) {
    return Error{fmt::format("pins: they would leave the symmetry {} that the run keeps", cage.symmetry.name)};
  }
  for (std::size_t i = 0; i < surface.pins.size(); ++i) {
    surface.pins[i].position = (*held)[i].position;
    surface.pins[i].normal = (*held)[i].normal;
  }
  return std::nullopt;
}

}  // namespace

Result<RefinedCage> with_targets(RefinedCage surface, const RefinedCage& cage, const Targets& targets,
                                 const Constraints& changed, CapKind cap) {
  if (!targets.pins.empty()) {
    if (changed.symmetric) return Error{"pins: those that constraints.symmetric copies cannot move under a run"};
    if (auto error = move_pins(cage, changed.pins, surface)) return *error;
    const Coordinates coordinates(surface.mesh, surface.symmetry, held_points(surface, cap));
    if (auto error = contradiction_of(surface, coordinates)) return *error;
  }
  if (targets.closeness) surface.closeness = std::ldexp(*targets.closeness, 4 * cage.placement.exponent);
  return surface;
}

}  // namespace umbilic
