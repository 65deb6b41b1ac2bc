// SPDX-License-Identifier: MIT
/// \file
/// Refinement of cages, and reports.
#include "driver/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "driver/contradiction.h"
#include "driver/gauss_bonnet.h"
#include "driver/held_faces.h"
#include "driver/pin_rows.h"
#include "mesh/components.h"
#include "mesh/coordinates.h"
#include "mesh/hierarchy.h"
#include "mesh/subgroup.h"
#include "surface/boundary_turning.h"

namespace umbilic {

double faces_after(const PolygonMesh& cage, int steps) {
  return steps == 0 ? cage.surface_face_count() : cage.surface_halfedge_count() * std::pow(4.0, steps - 1);
}

namespace {

/// Of each face of the mesh, from what is known of each face of the cage.
std::vector<bool> on_mesh(const std::vector<bool>& of_cage, const Cage& cage, const PolygonMesh& mesh) {
  if (of_cage.empty() || !mesh.is_open()) return of_cage;
  std::vector<bool> of_mesh;
  for (std::size_t f = 0, hole = 0; f < of_cage.size(); ++f) {
    const bool is_hole = hole < cage.holes.size() && cage.holes[hole] == static_cast<int>(f);
    if (is_hole) ++hole;
    if (!is_hole) of_mesh.push_back(of_cage[f]);
  }
  of_mesh.resize(mesh.face_count(), false);
  return of_mesh;
}

/// Of each quad of `finer`, from what is known of each face of the mesh.
std::vector<bool> on_quads(const std::vector<bool>& of_faces, const PolygonMesh& mesh, const PolygonMesh& finer) {
  std::vector<bool> of_quads(finer.face_count(), false);
  for (int h = 0; h < mesh.surface_halfedge_count(); ++h) of_quads[h] = of_faces[mesh.face(h)];
  return of_quads;
}

/// Copies the pins and the faces that the constraints hold, or free, to all places to which the symmetries map them.
std::optional<Error> copy_over_symmetry(const Constraints& constraints, const std::vector<Symmetry>& symmetries,
                                        const Vector3& center, RefinedCage& cage) {
  Result<std::vector<HeldPoint>> pins = with_images(cage.pins, symmetries, center, cage.mesh);
  if (!pins) return pins.error();
  cage.pins = std::move(pins).value();
  if (cage.held.empty()) return std::nullopt;
  std::vector<bool> given = cage.held;
  if (constraints.free) given.flip();
  std::vector<bool> all = images_of_faces(given, symmetries, cage.mesh);
  if (constraints.free) all.flip();
  cage.held = std::move(all);
  int held = 0;
  for (int f = 0; f < cage.mesh.face_count(); ++f) {
    if (!cage.mesh.is_surface(f)) cage.held[f] = false;
    held += cage.held[f];
  }
  if (held == cage.mesh.surface_face_count())
    return Error{"constraints.symmetric: all faces are held; nothing is free"};
  if (held == 0) cage.held.clear();
  return std::nullopt;
}

}  // namespace

Result<RefinedCage> prepare(const Cage& cage, int last_level, bool symmetric, const Constraints& constraints,
                            const std::optional<Placement>& given) {
  Result<std::vector<bool>> held = held_faces(cage, constraints);
  if (!held) return held.error();
  const Placement placement = given ? *given : placement_of(cage.vertices);
  RefinedCage result{0, PolygonMesh(cage), placement.to_unit(cage.vertices), {}, placement};
  result.held = on_mesh(*held, cage, result.mesh);
  const PolygonMesh& mesh = result.mesh;
  const Result<int> required = required_level(mesh);
  if (!required) return required.error();
  const int steps = std::max(last_level, *required);
  const double faces = faces_after(mesh, steps);
  if (faces > kMaxFaces) {
    return Error{fmt::format("level {} would have {:.3g} faces; at most {} are possible", steps, faces, kMaxFaces)};
  }
  SymmetryGroup group;
  if (symmetric || constraints.symmetric) group = find_symmetry(mesh, result.control);
  if (constraints.symmetric) {
    const Coordinates coordinates(mesh, group);
    result.control = coordinates.control(coordinates.unknowns(result.control));
  }
  if (symmetric) result.symmetry = group;
  if (constraints.any()) {
    Result<std::vector<HeldPoint>> pins = hold(constraints.pins, result);
    if (!pins) return pins.error();
    result.pins = std::move(pins).value();
  }
  std::vector<Symmetry> symmetries;  // over which constraints are copied
  if (constraints.symmetric) {
    symmetries = elements_of(group, mesh);
    if (symmetries.empty()) return Error{"constraints.symmetric: the cage's symmetry is too large to be listed"};
    if (auto error = copy_over_symmetry(constraints, symmetries, group.center, result)) return *error;
  }
  auto boundary =
      boundary_conditions(constraints.boundary.value_or(BoundaryConditions()), mesh, result.held, symmetries);
  if (!boundary) return boundary.error();
  result.boundary = std::move(boundary).value();
  if (constraints.closeness) {
    const double weight = constraints.closeness->weight.value_or(0);  // where it is sought, the run chooses
    result.closeness = std::ldexp(weight, 4 * placement.exponent);
  }
  const bool exact = !result.held.empty() || !result.pins.empty() || !result.boundary.empty();
  if (exact || result.closeness) result.own = result.control;
  if (exact) {
    const HeldFaces held_part(result.held, result.boundary, mesh, result.own);
    const Vector3 center = result.symmetry.center;
    result.symmetry = subgroup(result.symmetry, mesh, [&](const Symmetry& element) {
      return held_part.kept_by(element, center) && keeps(element, center, result.pins, mesh);
    });
  }
  const Coordinates coordinates(mesh, result.symmetry);
  result.control = coordinates.control(coordinates.unknowns(result.control));
  if (!exact && result.closeness) result.own = result.control;
  return result;
}

RefinedCage refine(RefinedCage cage, int steps) {
  for (; steps > 0; --steps) {
    Refinement finer = catmull_clark(cage.mesh);
    cage.symmetry =
        finer.mesh.is_open() ? refined(cage.symmetry, cage.mesh, finer.mesh) : refined(cage.symmetry, cage.mesh);
    // Of a size of its own, which only then takes the place: a matrix that Eigen fails to resize is freed twice.
    cage.control = Points(finer.stencil * cage.control);
    if (cage.is_constrained()) cage.own = Points(finer.stencil * cage.own);
    if (!cage.held.empty()) {
      cage.held = on_quads(cage.held, cage.mesh, finer.mesh);
    }
    cage.pins = refined(std::move(cage.pins), cage.mesh);
    cage.boundary = refined(cage.boundary, cage.mesh, finer.mesh);
    cage.mesh = std::move(finer.mesh);
    ++cage.level;
  }
  return cage;
}

namespace {

/// The vertices that touch no face on which the limit surface depends.
std::vector<bool> beyond_surface(const PolygonMesh& mesh) {
  std::vector<bool> beyond(mesh.vertex_count(), true);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto corner = [&](int i) { return mesh.origin(mesh.halfedge(f, i)); };
    bool touches = false;
    for (int i = 0; i < mesh.face_size(f); ++i) touches = touches || mesh.on_surface(corner(i));
    if (!touches || mesh.role(f) == FaceRole::kOuter) continue;
    for (int i = 0; i < mesh.face_size(f); ++i) beyond[corner(i)] = false;
  }
  return beyond;
}

}  // namespace

HeldPoints held_points(const RefinedCage& cage, CapChoice cap) {
  std::vector<bool> held;
  if (!cage.held.empty()) {
    held = PatchLayout(cage.mesh, cap, face_orbits(cage.mesh, {}), cage.held, Part::kHeld).used_control_points();
  }
  if (cage.mesh.is_open()) {
    const std::vector<bool> beyond = beyond_surface(cage.mesh);
    for (int v = 0; v < cage.mesh.vertex_count(); ++v) {
      if (!beyond[v]) continue;
      held.resize(cage.mesh.vertex_count(), false);
      held[v] = true;
    }
  }
  if (held.empty()) return {};
  return {std::move(held), cage.own};
}

Cage to_cage(const PolygonMesh& mesh, Points control) {
  Cage cage;
  cage.faces.resize(mesh.surface_face_count());
  for (int f = 0; f < mesh.surface_face_count(); ++f) {
    cage.faces[f].reserve(mesh.face_size(f));
    for (int i = 0; i < mesh.face_size(f); ++i) cage.faces[f].push_back(mesh.origin(mesh.halfedge(f, i)));
  }
  if (mesh.is_open()) {
    std::vector<int> number(mesh.vertex_count(), -1), kept;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (!mesh.on_surface(v)) continue;
      number[v] = static_cast<int>(kept.size());
      kept.push_back(v);
    }
    for (std::vector<int>& face : cage.faces) {
      for (int& v : face) v = number[v];
    }
    control = control(kept, Eigen::all).eval();
  }
  cage.vertices = std::move(control);
  return cage;
}

Result<RefinedCage> refine_to_evaluable(const Cage& cage, int level, bool symmetric) {
  Result<RefinedCage> prepared = prepare(cage, level, symmetric);
  if (!prepared) return prepared.error();
  const int steps = std::max(level, required_level(prepared->mesh).value());
  return refine(std::move(prepared).value(), steps);
}

bool diverges(const PolygonMesh& mesh, CapChoice cap, const Weights& weights, Error& error) {
  if (cap != CapKind::kNone) return false;
  const auto third = std::find_if(weights.begin() + kMvs, weights.end(), [](double w) { return w != 0; });
  if (third == weights.end()) return false;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.on_surface(v) || !mesh.is_extraordinary(v)) continue;
    error.message = fmt::format("{} diverges at extraordinary vertices (valence {}) with cap none; use smooth or flat",
                                kFunctionalNames[third - weights.begin()], mesh.valence(v));
    return true;
  }
  return false;
}

Surface::Surface(RefinedCage cage, CapChoice cap, const Weights& weights, int quadrature,
                 std::optional<double> fixed_area)
    : cage_(std::move(cage)),
      genera_(find_components(cage_.mesh).genera),
      weights_(weights),
      quadrature_(quadrature),
      fixed_area_(fixed_area),
      layout_(cage_.mesh, cap, face_orbits(cage_.mesh, cage_.symmetry), cage_.held, Part::kFree) {
  if (!cage_.held.empty()) whole_.emplace(cage_.mesh, cap, face_orbits(cage_.mesh, cage_.symmetry), cage_.held);
  if (cage_.closeness) closeness_ = std::make_unique<ClosenessTerm>(layout_, cage_.own, *cage_.closeness);
}

const JetEvaluator& Surface::jets() const {
  if (!jets_) jets_ = std::make_unique<JetEvaluator>(layout_, minimizing_rule(layout_.cap(), weights_, quadrature_));
  return *jets_;
}

const SurfaceEnergy& Surface::energy() const {
  if (!energy_) energy_ = std::make_unique<SurfaceEnergy>(jets(), weights_, fixed_area_);
  return *energy_;
}

SurfaceIntegrals Surface::free_integrals(const Points& control) const {
  if (!reporting_jets_) reporting_jets_ = std::make_unique<JetEvaluator>(layout_, reporting_rule(layout_.cap()));
  return surface_integrals(*reporting_jets_, control);
}

SurfaceIntegrals Surface::whole_integrals(const Points& control) const {
  if (!whole_) return free_integrals(control);
  if (!whole_reporting_jets_) {
    whole_reporting_jets_ = std::make_unique<JetEvaluator>(*whole_, reporting_rule(layout_.cap()));
  }
  return surface_integrals(*whole_reporting_jets_, control);
}

int Surface::narrowest_cap() const {
  int narrowest = 0;
  for (const Cap& cap : layout_.caps()) {
    if (narrowest == 0 || rings(cap.shape) < narrowest) narrowest = rings(cap.shape);
  }
  return narrowest;
}

double Surface::turning(const Points& control) const {
  return boundary_turning(mesh(), whole_layout(), whole_layout().extend(control));
}

double Surface::expected_gaussian() const {
  const double whole = 2 * std::numbers::pi * mesh().euler_characteristic();
  if (!whole_) return whole;
  const PatchLayout held(cage_.mesh, layout_.cap(), face_orbits(cage_.mesh, cage_.symmetry), cage_.held, Part::kHeld);
  return whole - surface_integrals(JetEvaluator(held, reporting_rule(layout_.cap())), cage_.own).gaussian;
}

EnergyReport Surface::report(const Points& control) const {
  const SurfaceIntegrals whole = whole_integrals(control), free = whole_ ? free_integrals(control) : whole;
  EnergyReport report;
  report.functionals = whole.functionals;
  report.invariants = {whole.invariants};
  report.area = in_own_units(whole.area);
  report.gaussian = whole.gaussian;
  if (whole_ || (fixed_area_ && third_order(weights_))) {
    report.free.emplace();
    report.free->functionals = free.functionals;
    report.free->area = in_own_units(free.area);
    if (fixed_area_) {
      for (int i = 0; i < kFunctionalCount; ++i) {
        report.free->functionals[i] *= area_to_the(area_power(i), *fixed_area_ / free.area);
      }
      report.free->area_factor = in_own_units(*fixed_area_);
    }
  }
  if (mesh().is_open()) report.boundary_turning = turning(control);
  const double defect =
      gauss_bonnet_defect(report.gaussian + report.boundary_turning.value_or(0), mesh().euler_characteristic());
  report.resolved = defect <= kLargestDefect;
  if (layout_.cap() == CapKind::kNone && !layout_.caps().empty()) {
    for (int i = 0; i < kFunctionalCount; ++i) {
      if (!is_third_order(i)) continue;
      report.functionals[i] = std::numeric_limits<double>::quiet_NaN();
      if (report.free) report.free->functionals[i] = report.functionals[i];
    }
    report.invariants.emplace();
  }
  const EnergyValue minimized = energy().evaluate(control, nullptr);
  report.quadrature_error = std::abs(objective(report) - minimized.energy);
  if (closeness_) report.closeness = closeness_->evaluate(control, nullptr);

  const double willmore = report.functionals[kWillmore];
  const double error = defect + std::abs(free.functionals[kWillmore] - willmore_by_minimizing_rule(control, minimized));
  Weights willmore_alone{};
  willmore_alone[kWillmore] = 1;
  report.below_bound = below(lower_bound(), objective(report), report.quadrature_error) ||
                       below(bound_of(willmore_alone), willmore, error);
  report.embedded = genera_.size() == 1 && !mesh().is_open() && report.resolved && !report.below_bound &&
                    willmore + error < kEmbeddedWillmore;
  return report;
}

/// Of the free faces. `value` is that of the weighted functional. Of a part of second order a B + b W = a (4 W - 2
/// integral of K) + b W.
double Surface::willmore_by_minimizing_rule(const Points& control, const EnergyValue& value) const {
  const double a = weights_[kBending], b = weights_[kWillmore];
  if (a + b > 0) return (value.integrals[0] + 2 * a * value.gaussian) / (4 * a + b);
  Weights willmore_alone{};
  willmore_alone[kWillmore] = 1;
  return SurfaceEnergy(jets(), willmore_alone).evaluate(control, nullptr).energy;
}

double Surface::objective(const EnergyReport& report) const {
  const std::array<double, kFunctionalCount>& functionals = report.free ? report.free->functionals : report.functionals;
  double sum = report.closeness.value_or(0);
  for (int i = 0; i < kFunctionalCount; ++i) {
    if (weights_[i] != 0) sum += weights_[i] * functionals[i];
  }
  return sum;
}

}  // namespace umbilic
