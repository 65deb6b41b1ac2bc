// SPDX-License-Identifier: MIT
/// \file
/// Automorphisms of a mesh: how they act on vertices and faces, and on the mesh after a Catmull-Clark step.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"

namespace umbilic {

/// A relabelling of a mesh that preserves its connectivity. Half-edge h maps to s(h) = halfedges[h], which lies in the
/// image of face(h), and s(twin(h)) = twin(s(h)).
///
/// If the orientation is preserved, s(next(h)) = next(s(h)) and origin(h) maps to origin(s(h)). If it is reversed (a
/// mirror), s(next(h)) = previous(s(h)) and origin(h) maps to target(s(h)).
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

/// The image of each vertex.
std::vector<int> vertex_images(const PolygonMesh& mesh, const Automorphism& map);

/// The same automorphism on catmull_clark(mesh).mesh, for a closed surface.
Automorphism refined(const Automorphism& map, const PolygonMesh& mesh);
/// The same for any surface; `finer` is catmull_clark(mesh).mesh.
Automorphism refined(const Automorphism& map, const PolygonMesh& mesh, const PolygonMesh& finer);

}  // namespace umbilic
