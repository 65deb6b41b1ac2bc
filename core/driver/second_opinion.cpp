// SPDX-License-Identifier: MIT
/// \file
/// Hands a surface over to core/opinion, and its integrals to the report.
#include "driver/second_opinion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "mesh/boundary.h"
#include "mesh/symmetry.h"
#include "opinion/plain_step.h"
#include "opinion/surface_integrals.h"
#include "surface/layout.h"

namespace umbilic {
namespace {

opinion::CapForm form_of(CapKind cap) {
  switch (cap) {
    case CapKind::kNone: return opinion::CapForm::kNone;
    case CapKind::kFlat: return opinion::CapForm::kPlane;
    case CapKind::kSmooth: return opinion::CapForm::kPolynomial;
  }
  return {};
}

opinion::PlainCap plain(const Cap& cap, const PolygonMesh& mesh, const Points& points) {
  const int on_boundary = boundary_halfedge(mesh, cap.vertex), count = coefficient_count(cap.shape);
  opinion::PlainCap result;
  result.halfedge = on_boundary < 0 ? mesh.outgoing(cap.vertex) : on_boundary;
  result.sectors = cap.sectors;
  result.rings = rings(cap.shape);
  result.degree = degree(cap.shape);
  if (count > 0) result.coefficients = points.middleRows(cap.first_coefficient, count);
  return result;
}

OpinionValues values_of(const opinion::Quantities& quantities, const Placement& placement) {
  OpinionValues values;
  OpinionValues::members(
      [&](std::string_view name, double& value, std::string_view) {
        const auto found = std::find_if(opinion::kQuantities.begin(), opinion::kQuantities.end(),
                                        [&](const opinion::Quantity& quantity) { return quantity.name == name; });
        assert(found != opinion::kQuantities.end());
        value = quantities[found - opinion::kQuantities.begin()];
      },
      values);
  values.area = std::ldexp(values.area, 2 * placement.exponent);
  return values;
}

/// The first face of each orbit counts as often as the orbit has faces.
std::vector<int> times_of(const Orbits& orbits) {
  std::vector<int> times(orbits.of.size(), 0);
  std::vector<bool> seen(orbits.sizes.size(), false);
  for (std::size_t f = 0; f < times.size(); ++f) {
    const int orbit = orbits.of[f];
    if (!seen[orbit]) times[f] = orbits.sizes[orbit];
    seen[orbit] = true;
  }
  return times;
}

}  // namespace

OpinionReport second_opinion(const RefinedCage& cage, CapChoice cap, const EnergyReport& energies, OpinionFaces faces) {
  const PatchLayout layout(cage.mesh, cap, face_orbits(cage.mesh, {}), cage.held);
  const Points points = layout.extend(cage.control);
  opinion::PlainSurface surface{cage.mesh, cage.control, form_of(cap)};
  if (faces == OpinionFaces::kOnePerOrbit) surface.times = times_of(face_orbits(cage.mesh, cage.symmetry));
  for (const Cap& here : layout.caps()) surface.caps.push_back(plain(here, cage.mesh, points));
  const opinion::Integrals integrals = opinion::integrate(surface);

  OpinionReport report;
  report.values = values_of(integrals.values, cage.placement);
  report.errors = values_of(integrals.errors, cage.placement);
  report.samples = integrals.samples;
  OpinionValues& differences = report.differences;
  differences.area = energies.area - report.values.area;
  differences.gaussian = energies.gaussian - report.values.gaussian;
  for (int i = 0; i < kFunctionalCount; ++i)
    differences.functionals[i] = energies.functionals[i] - report.values.functionals[i];
  if (energies.invariants) {
    for (int i = 0; i < kInvariantCount; ++i)
      differences.invariants[i] = energies.invariants->values[i] - report.values.invariants[i];
  }
  return report;
}

RefinedCage refine_otherwise(RefinedCage cage, int steps) {
  if (cage.mesh.is_open()) return refine(std::move(cage), steps);
  Cage plain = to_cage(cage.mesh, cage.control);
  for (int i = 0; i < steps; ++i) plain = opinion::refined(plain);
  RefinedCage result = refine(std::move(cage), steps);
  result.control = std::move(plain.vertices);
  return result;
}

}  // namespace umbilic
