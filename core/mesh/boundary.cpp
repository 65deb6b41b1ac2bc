// SPDX-License-Identifier: MIT
/// \file
/// Walks around vertices and along loops.
#include "mesh/boundary.h"

namespace umbilic {

int boundary_halfedge(const PolygonMesh& mesh, int v) {
  if (!mesh.is_open() || !mesh.on_surface(v)) return -1;
  const int first = mesh.outgoing(v);
  int h = first;
  do {
    if (mesh.is_boundary(h)) return h;
    h = mesh.rotate(h);
  } while (h != first);
  return -1;
}

int next_on_boundary(const PolygonMesh& mesh, int h) {
  int next = mesh.next(h);
  while (mesh.is_surface(mesh.face(mesh.twin(next)))) next = mesh.next(mesh.twin(next));
  return next;
}

int surface_valence(const PolygonMesh& mesh, int v) {
  if (!mesh.on_surface(v)) return 0;
  int h = mesh.outgoing(v), count = 0;
  do {
    count += mesh.is_surface(mesh.face(h));
    h = mesh.rotate(h);
  } while (h != mesh.outgoing(v));
  return count;
}

int surface_fans(const PolygonMesh& mesh, int v) {
  if (!mesh.on_surface(v)) return 0;
  int h = mesh.outgoing(v), leaving = 0;
  do {
    leaving += mesh.is_boundary(h);
    h = mesh.rotate(h);
  } while (h != mesh.outgoing(v));
  return leaving == 0 ? 1 : leaving;
}

std::vector<std::vector<int>> boundary_loops(const PolygonMesh& mesh) {
  std::vector<std::vector<int>> loops;
  if (!mesh.is_open()) return loops;
  std::vector<bool> seen(mesh.surface_halfedge_count(), false);
  for (int first = 0; first < mesh.surface_halfedge_count(); ++first) {
    if (seen[first] || !mesh.is_boundary(first)) continue;
    loops.emplace_back();
    for (int h = first; !seen[h]; h = next_on_boundary(mesh, h)) {
      seen[h] = true;
      loops.back().push_back(h);
    }
  }
  return loops;
}

std::vector<bool> bare_vertices(const PolygonMesh& mesh) {
  const auto touches_outer = [&](int v) {
    int h = mesh.outgoing(v);
    do {
      if (mesh.role(mesh.face(h)) == FaceRole::kOuter) return true;
      h = mesh.rotate(h);
    } while (h != mesh.outgoing(v));
    return false;
  };
  std::vector<bool> bare;
  for (const std::vector<int>& loop : boundary_loops(mesh)) {
    bool complete = true;
    for (const int h : loop) complete = complete && !touches_outer(mesh.origin(h));
    if (complete) continue;
    bare.resize(mesh.vertex_count(), false);
    for (const int h : loop) bare[mesh.origin(h)] = true;
  }
  return bare;
}

}  // namespace umbilic
