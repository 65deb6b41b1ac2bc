// SPDX-License-Identifier: MIT
/// \file
/// Floods regions, compares points, and puts the forces of driver/balance.h into the words of a report.
#include "driver/constraints_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "driver/balance.h"
#include "driver/equations.h"
#include "surface/patch_evaluator.h"

namespace umbilic {
namespace {

/// The deviation is taken over a grid of so many points along each edge of a patch.
constexpr QuadratureRule kDeviationRule{4, 4, 0};

std::array<double, 3> entries(const Vector3& vector) { return {vector[0], vector[1], vector[2]}; }

/// Positions at the samples of all patches, in a fixed order.
std::vector<Vector3> positions(const PatchLayout& layout, const Points& control) {
  PatchEvaluator patches(layout,
                         [](const PatchKind& kind) { return PatchBasis(shared_basis_table(kind, kDeviationRule, 0)); });
  patches.move_to(control);
  PatchMemory memory;
  std::vector<Vector3> result;
  for (const PatchRange& range : patches.ranges()) {
    const BasisTable& table = patches.basis(range.set).table();
    const double* jets = patches.jets(range, 1, memory, 0);
    for (int p = 0; p < range.count; ++p) {
      const double* x = jets + static_cast<std::size_t>(3) * p * table.samples;
      for (int s = 0; s < table.distinct; ++s) {
        result.emplace_back(x[s], x[table.samples + s], x[2 * table.samples + s]);
      }
    }
  }
  return result;
}

/// The region of each held control point, -1 for the others: the one whose faces are nearest.
std::vector<int> regions_of_points(const PolygonMesh& mesh, const HeldRegions& regions, const std::vector<bool>& held) {
  std::vector<int> result(mesh.vertex_count(), -1), reached = regions.of_face, queue;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (reached[f] >= 0) queue.push_back(f);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int f = queue[i];
    for (int k = 0; k < mesh.face_size(f); ++k) {
      const int h = mesh.halfedge(f, k), v = mesh.origin(h), neighbour = mesh.face(mesh.twin(h));
      if (held[v] && result[v] < 0) result[v] = reached[f];
      if (reached[neighbour] >= 0) continue;
      reached[neighbour] = reached[f];
      queue.push_back(neighbour);
    }
  }
  return result;
}

/// The point of the surface at a place of the mesh; `layout` covers all faces.
Vector3 surface_point(const PatchLayout& layout, const Points& points, const PolygonMesh& mesh, SurfacePlace place) {
  if (place.is_vertex()) place = {.vertex = -1, .halfedge = mesh.outgoing(place.vertex)};
  for (const PatchSet& set : layout.sets()) {
    for (int p = 0; p < set.count(); ++p) {
      int h = set.halfedges[p];
      if (mesh.face(h) != mesh.face(place.halfedge)) continue;
      double u = place.u, v = place.v;
      for (; h != place.halfedge; h = mesh.next(h)) {
        std::swap(u, v);  // a quarter turn takes (u, v) about one corner to (1 - v, u) about the corner before it
        u = 1 - u;
      }
      const CapShape shape = set.kind.shape;
      if (set.kind.at_extraordinary() && u == 0 && v == 0) {
        const Cap& cap = layout.caps()[set.caps[p]];
        if (coefficient_count(shape) > 0) return points.row(cap.first_coefficient);
        return LimitStencil(limit_stencils(mesh, {{.vertex = mesh.origin(set.halfedges[p])}}).front())
            .apply(points)
            .col(0);
      }
      const DerivativeRows basis = patch_basis(set.kind, u, v);
      Vector3 point = Vector3::Zero();
      for (int i = 0; i < set.columns; ++i) point += basis(0, i) * points.row(set.points_of(p)[i]).transpose();
      return point;
    }
  }
  return Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

double largest_deviation(const Surface& surface, const Points& control) {
  const std::vector<Vector3> now = positions(surface.layout(), control),
                             own = positions(surface.layout(), surface.cage().own);
  double largest = 0;
  for (std::size_t i = 0; i < now.size(); ++i) largest = std::max(largest, (now[i] - own[i]).norm());
  return largest;
}

HeldRegions::HeldRegions(const PolygonMesh& mesh, const std::vector<bool>& held)
    : of_face(mesh.face_count(), -1), surface_faces(mesh.surface_face_count()) {
  if (held.empty()) return;
  std::vector<int> queue;
  for (int first = 0; first < mesh.face_count(); ++first) {
    if (!held[first] || of_face[first] >= 0) continue;
    of_face[first] = count();
    queue.assign(1, first);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (int k = 0; k < mesh.face_size(queue[i]); ++k) {
        const int neighbour = mesh.face(mesh.twin(mesh.halfedge(queue[i], k)));
        if (!held[neighbour] || of_face[neighbour] >= 0) continue;
        of_face[neighbour] = of_face[first];
        queue.push_back(neighbour);
      }
    }
    first_faces.push_back(first);
    sizes.push_back(static_cast<int>(queue.size()));
  }
}

namespace {

/// A pull per unit of length as one per length of the cage.
Vector3 in_own_units(const Vector3& pull, const RefinedCage& cage) {
  return pull.unaryExpr([&](double x) { return std::ldexp(x, -cage.placement.exponent); });
}

void add_regions(const Balance& balance, const RefinedCage& cage, CapChoice cap, const HeldRegions& regions,
                 ConstraintsReport& report) {
  const PolygonMesh& mesh = cage.mesh;
  const HeldPoints held = held_points(cage, cap);
  if (!held.any()) return;
  const std::vector<int> region = regions_of_points(mesh, HeldRegions(mesh, cage.held), held.held);
  for (int r = 0; r < regions.count(); ++r) {
    Vector3 pull = Vector3::Zero();
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (region[v] == r) pull += balance.reactions.row(v).transpose();
    }
    pull = in_own_units(pull, cage);
    report.regions.push_back({regions.sizes[r], regions.first_faces[r] + 1, entries(pull), pull.norm()});
  }
}

void add_boundaries(const Balance& balance, const RefinedCage& cage, ConstraintsReport& report) {
  for (const LoopPull& loop : loop_pulls(balance, cage)) {
    const Vector3 force = in_own_units(loop.force, cage);
    report.boundaries.push_back({loop.loop + 1, entries(cage.placement.back(loop.center)), entries(force), force.norm(),
                                 std::ldexp(loop.total, -cage.placement.exponent), entries(loop.moment)});
  }
}

void add_pins(const Balance& balance, const Surface& surface, const Points& control, ConstraintsReport& report) {
  const RefinedCage& cage = surface.cage();
  const PolygonMesh& mesh = cage.mesh;
  const PatchLayout layout(mesh, surface.layout().cap(), face_orbits(mesh, {}), cage.held);
  const Points points = layout.extend(control);
  const std::vector<int> turned = turned_over(cage.pins, mesh, control);
  std::vector<SurfacePlace> places;
  for (const HeldPoint& pin : cage.pins) places.push_back(pin.place);
  const std::vector<LimitStencil> stencils = limit_stencils(mesh, places);
  for (std::size_t i = 0; i < cage.pins.size(); ++i) {
    const int number = static_cast<int>(i);
    const Vector3 here = stencils[i].apply(control).col(0),
                  force = in_own_units(pull(balance.rows, balance.multipliers, number), cage);
    PinReport pin;
    pin.pin = cage.pins[i].pin + 1;
    pin.copy = cage.pins[i].copy;
    pin.position = entries(cage.placement.back(here));
    pin.pull = entries(force);
    pin.strength = force.norm();
    pin.off_surface =
        std::ldexp((surface_point(layout, points, mesh, places[i]) - here).norm(), cage.placement.exponent);
    pin.turned_over = std::find(turned.begin(), turned.end(), number) != turned.end();
    report.pins.push_back(pin);
  }
}

}  // namespace

ConstraintsReport constraints_report(const Surface& surface, const Points& control, const HeldRegions& regions) {
  const RefinedCage& cage = surface.cage();
  ConstraintsReport report;
  report.free_faces = regions.surface_faces;
  for (const int size : regions.sizes) {
    report.held_faces += size;
    report.free_faces -= size;
  }
  report.deviation = std::ldexp(largest_deviation(surface, control), cage.placement.exponent);
  if (cage.closeness) report.closeness = std::ldexp(*cage.closeness, -4 * cage.placement.exponent);
  const Balance forces = balance_of(surface, control);
  add_regions(forces, cage, surface.layout().cap(), regions, report);
  add_boundaries(forces, cage, report);
  if (cage.pins.empty()) return report;
  add_pins(forces, surface, control, report);
  for (const int row : forces.redundant) {
    if (forces.rows.owners[row].pin < 0) continue;  // corners have some by their nature
    report.notes.push_back(fmt::format("{} follows from the others and was dropped", name_of(cage, forces.rows, row)));
  }
  return report;
}

}  // namespace umbilic
