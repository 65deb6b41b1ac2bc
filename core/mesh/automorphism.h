// SPDX-License-Identifier: MIT
/// \file
/// Automorphisms of a mesh: what they do to vertices and faces, and how Catmull-Clark carries them along.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"

namespace umbilic {

/// A relabelling that keeps a mesh: half-edge h goes to halfedges[h], which lies in the image of face(h). Where it
/// reverses the orientation, the image of origin(h) is target(halfedges[h]). With s(h) = halfedges[h] this means
/// s(twin(h)) = twin(s(h)), and s(next(h)) = next(s(h)), or previous(s(h)) where it reverses.
struct Automorphism {
  bool reverses = false;
  std::vector<int> halfedges;
};

inline int image_of_vertex(const PolygonMesh& mesh, const Automorphism& map, int v) {
  const int h = map.halfedges[mesh.outgoing(v)];
  return map.reverses ? mesh.target(h) : mesh.origin(h);
}

inline int image_of_face(const PolygonMesh& mesh, const Automorphism& map, int f) {
  return mesh.face(map.halfedges[mesh.halfedge(f, 0)]);
}

/// The images of all vertices.
std::vector<int> vertex_images(const PolygonMesh& mesh, const Automorphism& map);

/// The same automorphism on catmull_clark(mesh).mesh.
Automorphism refined(const Automorphism& map, const PolygonMesh& mesh);

}  // namespace umbilic
