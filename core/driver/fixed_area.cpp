// SPDX-License-Identifier: MIT
/// \file
/// Integrates over the whole surface, as if nothing was held.
#include "driver/fixed_area.h"

#include <utility>

#include "driver/equations.h"
#include "driver/rules.h"

namespace umbilic {
namespace {

double own_area(const RefinedCage& cage, int required, CapChoice cap) {
  RefinedCage own = cage;
  own.control = own.own;
  own.held.clear();
  own.pins.clear();
  own.boundary.clear();
  const RefinedCage refined = refine(std::move(own), required);
  const PatchLayout layout(refined.mesh, cap, face_orbits(refined.mesh, refined.symmetry));
  return surface_integrals(JetEvaluator(layout, reporting_rule(cap)), refined.control).area;
}

}  // namespace

std::optional<double> fixed_area_of(const RefinedCage& cage, int required, CapChoice cap) {
  if (!cage.is_constrained() || leaves_size_open(cage)) return std::nullopt;
  return own_area(cage, required, cap);
}

}  // namespace umbilic
