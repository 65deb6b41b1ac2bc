// SPDX-License-Identifier: MIT
/// \file
/// Face, edge and vertex rules of Catmull-Clark on polygons of any size.
#include "mesh/subdivision.h"

#include <vector>

namespace umbilic {
namespace {

void add_face_point(const PolygonMesh& mesh, int f, double weight, int row,
                    std::vector<Eigen::Triplet<double>>& entries) {
  const int size = mesh.face_size(f);
  for (int i = 0; i < size; ++i) entries.emplace_back(row, mesh.origin(mesh.halfedge(f, i)), weight / size);
}

}  // namespace

Refinement catmull_clark(const PolygonMesh& mesh) {
  const int vertices = mesh.vertex_count(), edges = mesh.edge_count(), faces = mesh.face_count();
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<std::vector<int>> quads(mesh.halfedge_count());

  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const int edge_row = vertices + mesh.edge(h);
    entries.emplace_back(edge_row, mesh.origin(h), 0.25);
    add_face_point(mesh, mesh.face(h), 0.25, edge_row, entries);

    const int v = mesh.origin(h);
    const double n = mesh.valence(v);
    entries.emplace_back(v, v, 1 / (n * n));
    entries.emplace_back(v, mesh.target(h), 1 / (n * n));
    add_face_point(mesh, mesh.face(h), 1 / (n * n), v, entries);

    quads[h] = {v, edge_row, vertices + edges + mesh.face(h), vertices + mesh.edge(mesh.previous(h))};
  }
  for (int v = 0; v < vertices; ++v) entries.emplace_back(v, v, (mesh.valence(v) - 3.0) / mesh.valence(v));
  for (int f = 0; f < faces; ++f) add_face_point(mesh, f, 1, vertices + edges + f, entries);

  const int refined = vertices + edges + faces;
  Refinement result{PolygonMesh(refined, quads), SparseMatrix(refined, vertices)};
  result.stencil.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace umbilic
