// SPDX-License-Identifier: MIT
/// \file
/// Moves pins, whose places stay, and the cage's points, whose faces stay.
#include "driver/retarget.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

/// The part of the moved cage's symmetry that the group before had, with the isometries of the moved cage.
SymmetryGroup common_symmetry(const SymmetryGroup& before, const RefinedCage& moved) {
  const std::vector<Symmetry> known = elements_of(before, moved.mesh);
  return subgroup(moved.symmetry, moved.mesh, [&](const Symmetry& element) {
    return std::any_of(known.begin(), known.end(), [&](const Symmetry& other) {
      return element.map.reverses == other.map.reverses && element.map.halfedges == other.map.halfedges;
    });
  });
}

bool holds_the_same(const RefinedCage& a, const RefinedCage& b) {
  const auto same_place = [](const HeldPoint& one, const HeldPoint& other) {
    return one.pin == other.pin && one.copy == other.copy && one.place == other.place;
  };
  return a.held == b.held && a.boundary == b.boundary &&
         std::equal(a.pins.begin(), a.pins.end(), b.pins.begin(), b.pins.end(), same_place);
}

/// Prepares the moved cage as a new run would, and refines it to the surface's level.
std::optional<Error> move_points(const Cage& own, const Constraints& constraints, Retargeted& result) {
  const RefinedCage& before = result.cage;
  const int level = result.surface.level;
  Result<RefinedCage> moved = prepare(own, level, before.symmetry.order > 1, constraints, before.placement);
  if (!moved) return moved.error();
  if (!holds_the_same(*moved, before)) {
    return Error{"points: constraints.symmetric copies what is held to other places than before; that takes a new run"};
  }
  const int order = moved->symmetry.order;
  moved->symmetry = common_symmetry(before.symmetry, *moved);
  result.cage = *std::move(moved);
  if (result.cage.is_constrained()) {
    RefinedCage refined = refine(result.cage, level);
    refined.control = std::move(result.surface.control);
    refined.closeness = result.surface.closeness;
    if (result.surface.symmetry.order == 1) refined.symmetry = {};
    result.surface = std::move(refined);
  }
  result.has_cages_symmetry = order == result.cage.symmetry.order && order == result.surface.symmetry.order;
  return std::nullopt;
}

}  // namespace

Result<Retargeted> with_targets(RefinedCage surface, RefinedCage cage, const Targets& targets,
                                const Constraints& changed, const Cage& own, CapChoice cap) {
  Retargeted result{std::move(cage), std::move(surface)};
  if (targets.points) {
    if (auto error = move_points(own, changed, result)) return *error;
  } else if (!targets.pins.empty()) {
    if (auto error = move_pins(result.cage, changed, result.surface)) return *error;
  }
  RefinedCage& moved = result.surface;
  if (targets.points || !targets.pins.empty()) {
    const Coordinates coordinates(moved.mesh, moved.symmetry, held_points(moved, cap));
    if (auto error = contradiction_of(moved, coordinates)) return *error;
  }
  if (targets.closeness) moved.closeness = std::ldexp(*targets.closeness, 4 * moved.placement.exponent);
  return result;
}

}  // namespace umbilic
