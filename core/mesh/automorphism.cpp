// SPDX-License-Identifier: MIT
/// \file
/// Vertex images, and how an automorphism permutes the quads of the refined mesh.
#include "mesh/automorphism.h"

#include <utility>

namespace umbilic {

std::vector<int> vertex_images(const PolygonMesh& mesh, const Automorphism& map) {
  std::vector<int> images(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) images[v] = image_of_vertex(mesh, map, v);
  return images;
}

namespace {

/// The quad of each half-edge of the surface maps to the quad of the half-edge that leaves the image of its origin in
/// the image of its face. Results for the surface's quads only; the others are -1.
Automorphism refined_surface(const Automorphism& map, const PolygonMesh& mesh, int halfedge_count) {
  Automorphism result{map.reverses, std::vector<int>(halfedge_count, -1)};
  for (int h = 0; h < mesh.surface_halfedge_count(); ++h) {
    const int image = map.reverses ? mesh.next(map.halfedges[h]) : map.halfedges[h];
    for (int k = 0; k < 4; ++k) result.halfedges[4 * h + k] = 4 * image + (map.reverses ? 3 - k : k);
  }
  return result;
}

}  // namespace

Automorphism refined(const Automorphism& map, const PolygonMesh& mesh) {
  return refined_surface(map, mesh, 4 * mesh.surface_halfedge_count());
}

Automorphism refined(const Automorphism& map, const PolygonMesh& mesh, const PolygonMesh& finer) {
  Automorphism result = refined_surface(map, mesh, finer.halfedge_count());
  // Ghosts and outer faces follow from what the surface does, edge by edge.
  std::vector<int> queue;
  for (int h = 0; h < finer.surface_halfedge_count(); ++h) {
    if (finer.is_boundary(h)) queue.push_back(h);
  }
  while (!queue.empty()) {
    const int h = queue.back(), image = result.halfedges[h];
    queue.pop_back();
    const std::pair<int, int> known[] = {{finer.twin(h), finer.twin(image)},
                                         {finer.next(h), map.reverses ? finer.previous(image) : finer.next(image)}};
    for (const auto& [from, to] : known) {
      if (result.halfedges[from] >= 0) continue;
      result.halfedges[from] = to;
      queue.push_back(from);
    }
  }
  return result;
}

}  // namespace umbilic
