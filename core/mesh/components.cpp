// SPDX-License-Identifier: MIT
/// \file
/// Floods the half-edges, and counts the vertices, edges and faces that it comes to.
#include "mesh/components.h"

namespace umbilic {

MeshComponents find_components(const PolygonMesh& mesh) {
  MeshComponents result;
  result.of_vertex.assign(mesh.vertex_count(), -1);
  std::vector<bool> seen(mesh.halfedge_count(), false);
  std::vector<int> queue;
  for (int first = 0; first < mesh.halfedge_count(); ++first) {
    if (seen[first]) continue;
    int vertices = 0, halfedges = 0, faces = 0;
    queue.assign(1, first);
    seen[first] = true;
    while (!queue.empty()) {
      const int h = queue.back();
      queue.pop_back();
      ++halfedges;
      int& component = result.of_vertex[mesh.origin(h)];
      if (component < 0) {
        component = static_cast<int>(result.genera.size());
        ++vertices;
      }
      if (h == mesh.halfedge(mesh.face(h), 0)) ++faces;
      for (const int neighbour : {mesh.next(h), mesh.twin(h)}) {
        if (seen[neighbour]) continue;
        seen[neighbour] = true;
        queue.push_back(neighbour);
      }
    }
    result.genera.push_back((2 - (vertices - halfedges / 2 + faces)) / 2);
  }
  return result;
}

}  // namespace umbilic
