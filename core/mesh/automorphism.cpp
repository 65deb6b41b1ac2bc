// SPDX-License-Identifier: MIT
/// \file
/// Vertex images, and how an automorphism permutes the quads of the refined mesh.
#include "mesh/automorphism.h"

namespace umbilic {

std::vector<int> vertex_images(const PolygonMesh& mesh, const Automorphism& map) {
  std::vector<int> images(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) images[v] = image_of_vertex(mesh, map, v);
  return images;
}

Automorphism refined(const Automorphism& map, const PolygonMesh& mesh) {
  Automorphism result{map.reverses, std::vector<int>(4 * map.halfedges.size())};
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    // Refinement makes one quad for each half-edge. That of h maps to the quad of the half-edge that leaves the image
    // of origin(h) in the image of face(h).
    const int image = map.reverses ? mesh.next(map.halfedges[h]) : map.halfedges[h];
    for (int k = 0; k < 4; ++k) result.halfedges[4 * h + k] = 4 * image + (map.reverses ? 3 - k : k);
  }
  return result;
}

}  // namespace umbilic
