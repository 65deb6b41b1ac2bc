// SPDX-License-Identifier: MIT
/// \file
/// Counts over a cage's vertices and faces.
#include "cli/cage_shape.h"

#include "mesh/hierarchy.h"
#include "mesh/polygon_mesh.h"

namespace umbilic::cli {

CageShape shape_of(const Cage& cage) {
  CageShape shape;
  const PolygonMesh mesh(cage);
  for (int v = 0; v < mesh.vertex_count(); ++v) ++shape.valences[mesh.valence(v)];
  for (int f = 0; f < mesh.face_count(); ++f) ++shape.face_sizes[mesh.face_size(f)];
  const Result<int> level = required_level(mesh);
  if (level) {
    shape.first_level = *level;
  } else {
    shape.obstacle = level.error().message;
  }
  return shape;
}

}  // namespace umbilic::cli
