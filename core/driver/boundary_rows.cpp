// SPDX-License-Identifier: MIT
/// \file
/// Walks around boundary vertices.
#include "driver/boundary_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/boundary.h"

namespace umbilic {
namespace {

/// The half-edges out of a vertex, counterclockwise from `first`.
std::vector<int> spokes_from(const PolygonMesh& mesh, int first) {
  std::vector<int> spokes;
  int h = first;
  do {
    spokes.push_back(h);
    h = mesh.rotate(h);
  } while (h != first);
  return spokes;
}

/// The corner of a spoke's face that is opposite the vertex.
int opposite(const PolygonMesh& mesh, int spoke) { return mesh.target(mesh.next(spoke)); }

class Rows {
 public:
  Rows(const PolygonMesh& mesh, std::vector<PointRow>& rows) : mesh_(mesh), rows_(rows) {}

  /// At the vertex where the boundary's half-edge `out` begins, between stretches with the conditions `before` and
  /// `after`.
  void add(int out, BoundaryCondition before, BoundaryCondition after) {
    const BoundaryCondition both = std::max(before, after);
    if (both == BoundaryCondition::kFree) return;
    vertex_ = mesh_.origin(out);
    const std::vector<int> spokes = spokes_from(mesh_, out);
    const std::size_t faces = static_cast<std::size_t>(surface_valence(mesh_, vertex_));
    if (spokes.size() == 4) {
      regular(spokes, faces, before, after);
    } else if (spokes.size() == 2 * faces) {
      mirrored_ring(spokes, faces, both);
    } else {
      hold_ring(spokes);
    }
  }

 private:
  void hold(std::vector<int> points, std::vector<double> weights) {
    rows_.push_back({std::move(points), std::move(weights), vertex_});
  }

  /// Of the row through the points outside, on and inside the boundary.
  void across(int outside, int on, int inside, BoundaryCondition condition) {
    if (condition >= BoundaryCondition::kPosition) hold({outside, on, inside}, {1 / 6., 4 / 6., 1 / 6.});
    if (condition >= BoundaryCondition::kTangent) hold({outside, inside}, {-0.5, 0.5});
    if (condition >= BoundaryCondition::kCurvature) hold({outside, on, inside}, {1, -2, 1});
  }

  /// Where four faces meet the surface is a B-spline, and the boundary follows its parameter lines. In the net around
  /// the vertex the half-edge with which the boundary leaves runs to the right.
  void regular(const std::vector<int>& spokes, std::size_t faces, BoundaryCondition before, BoundaryCondition after) {
    const int right = mesh_.target(spokes[0]), above = mesh_.target(spokes[1]), left = mesh_.target(spokes[2]),
              below = mesh_.target(spokes[3]);
    const int net[3][3] = {{opposite(mesh_, spokes[2]), below, opposite(mesh_, spokes[3])},
                           {left, vertex_, right},
                           {opposite(mesh_, spokes[1]), above, opposite(mesh_, spokes[0])}};
    if (faces == 2) return across(below, vertex_, above, std::max(before, after));
    const bool convex = faces == 1;
    for (int i = 0; i < 2; ++i) {
      across(net[0][i], net[1][i], net[2][i], after);
      if (convex) {  // the boundary comes from above
        across(net[i][0], net[i][1], net[i][2], before);
      } else {  // from below
        across(net[i + 1][2], net[i + 1][1], net[i + 1][0], before);
      }
    }
  }

  /// Where ghosts mirror the surface's faces.
  void mirrored_ring(const std::vector<int>& spokes, std::size_t faces, BoundaryCondition condition) {
    if (condition >= BoundaryCondition::kTangent) return hold_ring(spokes);
    const std::size_t count = spokes.size();
    hold({vertex_}, {1});
    hold({mesh_.target(spokes[0])}, {1});
    hold({mesh_.target(spokes[faces])}, {1});
    for (std::size_t j = 1; j < faces; ++j) {
      hold({mesh_.target(spokes[j]), mesh_.target(spokes[count - j])}, {1, 1});
    }
    for (std::size_t j = 0; j < faces; ++j) {
      hold({opposite(mesh_, spokes[j]), opposite(mesh_, spokes[count - 1 - j])}, {1, 1});
    }
  }

  /// Everything on which the surface depends near the vertex.
  void hold_ring(const std::vector<int>& spokes) {
    hold({vertex_}, {1});
    for (const int spoke : spokes) {
      hold({mesh_.target(spoke)}, {1});
      hold({opposite(mesh_, spoke)}, {1});
    }
  }

  const PolygonMesh& mesh_;
  std::vector<PointRow>& rows_;
  int vertex_ = 0;
};

/// Whether all of the surface's faces at a vertex are held.
bool surface_is_held(const PolygonMesh& mesh, int v, const std::vector<bool>& held) {
  if (held.empty()) return false;
  for (const int spoke : spokes_from(mesh, mesh.outgoing(v))) {
    if (mesh.is_surface(mesh.face(spoke)) && !held[mesh.face(spoke)]) return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<int>> numbered_loops(const PolygonMesh& mesh) {
  std::vector<std::vector<int>> loops = boundary_loops(mesh);
  const auto first_vertex = [&](const std::vector<int>& loop) {
    int first = mesh.vertex_count();
    for (const int h : loop) first = std::min(first, mesh.origin(h));
    return first;
  };
  std::sort(loops.begin(), loops.end(),
            [&](const auto& a, const auto& b) { return first_vertex(a) < first_vertex(b); });
  return loops;
}

namespace {

/// Copies what is listed for half-edges to where the symmetries map them. `entry` has for each half-edge the index of
/// the listed loop that it belongs to, or -1.
std::optional<Error> copy_listed(const std::vector<Symmetry>& symmetries, const std::vector<int>& entry,
                                 std::vector<BoundaryCondition>& conditions) {
  for (int h = 0; h < static_cast<int>(entry.size()); ++h) {
    if (entry[h] < 0) continue;
    for (const Symmetry& symmetry : symmetries) {
      const int image = symmetry.map.halfedges[h];
      if (entry[image] >= 0 && conditions[image] != conditions[h]) {
        return Error{
            fmt::format("constraints.boundary.loops[{}].condition: {}, but constraints.symmetric copies loops[{}] to "
                        "there, which is {}",
                        entry[image], name_of(conditions[image]), entry[h], name_of(conditions[h]))};
      }
      conditions[image] = conditions[h];
    }
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<BoundaryCondition>> boundary_conditions(const BoundaryConditions& conditions,
                                                           const PolygonMesh& mesh, const std::vector<bool>& held,
                                                           const std::vector<Symmetry>& symmetries) {
  if (!mesh.is_open()) {
    if (conditions.loops.empty()) return std::vector<BoundaryCondition>();
    return Error{"constraints.boundary.loops[0]: the cage is closed"};
  }
  std::vector<BoundaryCondition> result(mesh.surface_halfedge_count(), conditions.condition);
  std::vector<int> entry(mesh.surface_halfedge_count(), -1);
  const std::vector<std::vector<int>> loops = numbered_loops(mesh);
  for (std::size_t i = 0; i < conditions.loops.size(); ++i) {
    const LoopCondition& wanted = conditions.loops[i];
    const auto refused = [&](std::string_view member, const std::string& words) {
      return Error{fmt::format("constraints.boundary.loops[{}].{}: {}", i, member, words)};
    };
    if (wanted.loop < 1 || wanted.loop > static_cast<int>(loops.size())) {
      return refused("loop", fmt::format("there is no boundary {}; the cage has {}", wanted.loop, loops.size()));
    }
    const std::vector<int>& loop = loops[wanted.loop - 1];
    if (wanted.from.has_value() != wanted.to.has_value()) return refused("from", "a stretch needs from and to");
    std::size_t begin = 0, count = loop.size();
    if (wanted.from) {
      const auto at = [&](int number) {
        return std::find_if(loop.begin(), loop.end(), [&](int h) { return mesh.origin(h) == number - 1; });
      };
      const auto from = at(*wanted.from), to = at(*wanted.to);
      if (from == loop.end()) return refused("from", fmt::format("vertex {} is not on that boundary", *wanted.from));
      if (to == loop.end()) return refused("to", fmt::format("vertex {} is not on that boundary", *wanted.to));
      begin = static_cast<std::size_t>(from - loop.begin());
      count = (static_cast<std::size_t>(to - loop.begin()) + loop.size() - begin) % loop.size();
      if (count == 0) count = loop.size();
    }
    for (std::size_t k = 0; k < count; ++k) {
      const int h = loop[(begin + k) % loop.size()];
      result[h] = wanted.condition;
      entry[h] = static_cast<int>(i);
    }
  }
  if (auto error = copy_listed(symmetries, entry, result)) return *error;
  const std::vector<bool> bare = bare_vertices(mesh);
  const auto tells_curvature = [&](int v) { return bare.empty() || !bare[v] || surface_is_held(mesh, v, held); };
  for (int h = 0; h < mesh.surface_halfedge_count(); ++h) {
    if (!mesh.is_boundary(h) || result[h] != BoundaryCondition::kCurvature) continue;
    if (tells_curvature(mesh.origin(h)) && tells_curvature(mesh.target(h))) continue;
    return Error{fmt::format(
        "constraints.boundary: the cage says nothing of the curvature across its boundary at vertex {}: hold "
        "the faces next to it, or mark the outermost ones as holes",
        mesh.origin(h) + 1)};
  }
  return result;
}

std::vector<BoundaryCondition> refined(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh,
                                       const PolygonMesh& finer) {
  if (conditions.empty()) return {};
  std::vector<BoundaryCondition> result(finer.surface_halfedge_count(), BoundaryCondition::kFree);
  for (int h = 0; h < mesh.surface_halfedge_count(); ++h) {
    if (!mesh.is_boundary(h)) continue;
    result[4 * h] = conditions[h];                 // the half at its origin is in the quad of h
    result[4 * mesh.next(h) + 3] = conditions[h];  // the other half is in that of the next half-edge
  }
  return result;
}

bool holds_boundary(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh) {
  for (std::size_t h = 0; h < conditions.size(); ++h) {
    if (mesh.is_boundary(static_cast<int>(h)) && conditions[h] != BoundaryCondition::kFree) return true;
  }
  return false;
}

bool holds_tangents(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh) {
  for (std::size_t h = 0; h < conditions.size(); ++h) {
    if (mesh.is_boundary(static_cast<int>(h)) && conditions[h] < BoundaryCondition::kTangent) return false;
  }
  return !conditions.empty();
}

std::vector<PointRow> boundary_rows(const std::vector<BoundaryCondition>& conditions, const PolygonMesh& mesh) {
  std::vector<PointRow> rows;
  if (conditions.empty()) return rows;
  Rows adder(mesh, rows);
  for (const std::vector<int>& loop : boundary_loops(mesh)) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      adder.add(loop[i], conditions[loop[(i + loop.size() - 1) % loop.size()]], conditions[loop[i]]);
    }
  }
  return rows;
}

}  // namespace umbilic
