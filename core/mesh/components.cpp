// SPDX-License-Identifier: MIT
/// \file
/// Floods the surface's half-edges, and counts the vertices, edges, faces and boundaries that it comes to.
#include "mesh/components.h"

#include "mesh/boundary.h"

namespace umbilic {
namespace {

/// Vertices without surface get the component of a neighbour.
void spread_to_ghosts(const PolygonMesh& mesh, std::vector<int>& of_vertex) {
  for (bool changed = true; changed;) {
    changed = false;
    for (int h = mesh.surface_halfedge_count(); h < mesh.halfedge_count(); ++h) {
      int& component = of_vertex[mesh.origin(h)];
      if (component >= 0 || of_vertex[mesh.target(h)] < 0) continue;
      component = of_vertex[mesh.target(h)];
      changed = true;
    }
  }
}

}  // namespace

MeshComponents find_components(const PolygonMesh& mesh) {
  MeshComponents result;
  result.of_vertex.assign(mesh.vertex_count(), -1);
  std::vector<bool> seen(mesh.surface_halfedge_count(), false);
  std::vector<int> queue, characteristics;
  for (int first = 0; first < mesh.surface_halfedge_count(); ++first) {
    if (seen[first]) continue;
    int vertices = 0, edges = 0, faces = 0;
    queue.assign(1, first);
    seen[first] = true;
    while (!queue.empty()) {
      const int h = queue.back();
      queue.pop_back();
      int& component = result.of_vertex[mesh.origin(h)];
      if (component < 0) {
        component = static_cast<int>(characteristics.size());
        ++vertices;
      }
      if (h == mesh.halfedge(mesh.face(h), 0)) ++faces;
      if (h < mesh.twin(h)) ++edges;
      for (const int neighbour : {mesh.next(h), mesh.twin(h)}) {
        if (!mesh.is_surface(mesh.face(neighbour)) || seen[neighbour]) continue;
        seen[neighbour] = true;
        queue.push_back(neighbour);
      }
    }
    characteristics.push_back(vertices - edges + faces);
  }
  result.boundaries.assign(characteristics.size(), 0);
  for (const std::vector<int>& loop : boundary_loops(mesh)) ++result.boundaries[result.of_vertex[mesh.origin(loop[0])]];
  for (std::size_t c = 0; c < characteristics.size(); ++c) {
    result.genera.push_back((2 - characteristics[c] - result.boundaries[c]) / 2);
  }
  if (mesh.is_open()) spread_to_ghosts(mesh, result.of_vertex);
  return result;
}

}  // namespace umbilic
