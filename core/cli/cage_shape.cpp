// SPDX-License-Identifier: MIT
/// \file
/// Counts over a cage's vertices and faces.
#include "cli/cage_shape.h"

#include "cage/boundary.h"
#include "cage/edges.h"
#include "mesh/hierarchy.h"
#include "mesh/polygon_mesh.h"

namespace umbilic::cli {

CageShape shape_of(const Cage& cage) {
  CageShape shape;
  const Cage surface = without_holes(cage);
  std::vector<int> valence(surface.vertices.rows(), 0);
  const std::vector<EdgeUse> uses = edge_uses(surface);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (i > 0 && same_edge(uses[i - 1], uses[i])) continue;
    ++valence[uses[i].low];
    ++valence[uses[i].high];
  }
  for (const int edges : valence) {
    if (edges > 0) ++shape.valences[edges];
  }
  for (const std::vector<int>& face : surface.faces) ++shape.face_sizes[static_cast<int>(face.size())];
  const Result<int> level = required_level(PolygonMesh(cage));
  if (level) {
    shape.first_level = *level;
  } else {
    shape.obstacle = level.error().message;
  }
  return shape;
}

}  // namespace umbilic::cli
