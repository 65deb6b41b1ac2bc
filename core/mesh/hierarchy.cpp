// SPDX-License-Identifier: MIT
/// \file
/// Counts extraordinary vertices per face, and predicts them after a step.
#include "mesh/hierarchy.h"

#include <fmt/format.h>

#include <vector>

#include "mesh/boundary.h"

namespace umbilic {

namespace {

/// Whether the limit of the surface depends on the face: it is of the surface, or a ghost that touches it.
bool matters(const PolygonMesh& mesh, int f) {
  if (mesh.role(f) != FaceRole::kGhost) return mesh.is_surface(f);
  for (int i = 0; i < mesh.face_size(f); ++i) {
    if (mesh.on_surface(mesh.origin(mesh.halfedge(f, i)))) return true;
  }
  return false;
}

}  // namespace

bool is_evaluable(const PolygonMesh& mesh) {
  if (!bare_vertices(mesh).empty()) return false;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (!matters(mesh, f)) continue;
    if (mesh.face_size(f) != 4) return false;
    if (!mesh.is_surface(f)) continue;
    int extraordinary = 0;
    for (int i = 0; i < 4; ++i) extraordinary += mesh.is_extraordinary(mesh.origin(mesh.halfedge(f, i)));
    if (extraordinary > 1) return false;
  }
  return true;
}

Result<int> required_level(const PolygonMesh& mesh) {
  const std::vector<bool> bare = bare_vertices(mesh);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_open() && !mesh.on_surface(v)) continue;
    if (mesh.is_open() && surface_fans(mesh, v) > 1) {
      return Error{fmt::format("vertex {} joins {} fans of faces with holes between them: not a manifold", v + 1,
                               surface_fans(mesh, v))};
    }
    if (!bare.empty() && bare[v]) {
      const int faces = surface_valence(mesh, v);
      if (2 * faces <= kMaxValence) continue;
      return Error{fmt::format("vertex {} has {} faces and lies on the boundary, where at most {} are possible", v + 1,
                               faces, kMaxValence / 2)};
    }
    if (mesh.valence(v) < kMinValence || mesh.valence(v) > kMaxValence) {
      return Error{fmt::format("vertex {} has valence {}; the limit surface is evaluated for valences {} to {}", v + 1,
                               mesh.valence(v), kMinValence, kMaxValence)};
    }
  }
  bool all_quads = true;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (!matters(mesh, f)) continue;
    if (mesh.is_surface(f) && mesh.face_size(f) > kMaxValence) {
      return Error{
          fmt::format("face {} has {} sides and would become a vertex of that valence; at most {} are possible", f + 1,
                      mesh.face_size(f), kMaxValence)};
    }
    all_quads = all_quads && mesh.face_size(f) == 4;
  }
  if (is_evaluable(mesh)) return 0;
  if (all_quads) return 1;  // one step separates the old vertices, and each face point has valence 4
  return is_evaluable(catmull_clark_mesh(mesh)) ? 1 : 2;
}

}  // namespace umbilic
