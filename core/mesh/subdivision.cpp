// SPDX-License-Identifier: MIT
/// \file
/// Face, edge and vertex rules of Catmull-Clark on polygons of any size.
#include "mesh/subdivision.h"

#include <array>
#include <vector>

#include "mesh/open_subdivision.h"

namespace umbilic {
namespace {

void add_face_point(const PolygonMesh& mesh, int f, double weight, int row,
                    std::vector<Eigen::Triplet<double>>& entries) {
  const int size = mesh.face_size(f);
  for (int i = 0; i < size; ++i) entries.emplace_back(row, mesh.origin(mesh.halfedge(f, i)), weight / size);
}

}  // namespace

PolygonMesh catmull_clark_mesh(const PolygonMesh& mesh) {
  if (mesh.is_open()) return open_catmull_clark_mesh(mesh);
  const int vertices = mesh.vertex_count(), edges = mesh.edge_count(), faces = mesh.face_count();
  std::vector<std::array<int, 4>> quads(mesh.halfedge_count());
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    quads[h] = {mesh.origin(h), vertices + mesh.edge(h), vertices + edges + mesh.face(h),
                vertices + mesh.edge(mesh.previous(h))};
  }
  return PolygonMesh::of_quads(vertices + edges + faces, quads);
}

Refinement catmull_clark(const PolygonMesh& mesh) {
  if (mesh.is_open()) return open_catmull_clark(mesh);
  const int vertices = mesh.vertex_count(), edges = mesh.edge_count(), faces = mesh.face_count();
  std::vector<Eigen::Triplet<double>> entries;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const int edge_row = vertices + mesh.edge(h);
    entries.emplace_back(edge_row, mesh.origin(h), 0.25);
    add_face_point(mesh, mesh.face(h), 0.25, edge_row, entries);

    const int v = mesh.origin(h);
    const double n = mesh.valence(v);
    entries.emplace_back(v, v, 1 / (n * n));
    entries.emplace_back(v, mesh.target(h), 1 / (n * n));
    add_face_point(mesh, mesh.face(h), 1 / (n * n), v, entries);
  }
  for (int v = 0; v < vertices; ++v) entries.emplace_back(v, v, (mesh.valence(v) - 3.0) / mesh.valence(v));
  for (int f = 0; f < faces; ++f) add_face_point(mesh, f, 1, vertices + edges + f, entries);

  Refinement result{catmull_clark_mesh(mesh), SparseMatrix(vertices + edges + faces, vertices)};
  result.stencil.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace umbilic
