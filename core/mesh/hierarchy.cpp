// SPDX-License-Identifier: MIT
/// \file
/// Counts extraordinary vertices per face, and predicts them after a step.
#include "mesh/hierarchy.h"

#include <fmt/format.h>

namespace umbilic {

bool is_evaluable(const PolygonMesh& mesh) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_size(f) != 4) return false;
    int extraordinary = 0;
    for (int i = 0; i < 4; ++i) extraordinary += mesh.is_extraordinary(mesh.origin(mesh.halfedge(f, i)));
    if (extraordinary > 1) return false;
  }
  return true;
}

Result<int> required_level(const PolygonMesh& mesh) {
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.valence(v) < kMinValence || mesh.valence(v) > kMaxValence) {
      return Error{fmt::format("vertex {} has valence {}; the limit surface is evaluated for valences {} to {}", v + 1,
                               mesh.valence(v), kMinValence, kMaxValence)};
    }
  }
  bool all_quads = true;
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_size(f) > kMaxValence) {
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
