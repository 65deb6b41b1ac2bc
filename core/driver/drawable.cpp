// SPDX-License-Identifier: MIT
/// \file
/// Triangles from polygons and quads, and edges.
#include "driver/drawable.h"

#include <algorithm>

#include "mesh/polygon_mesh.h"

namespace umbilic {
namespace {

template <class Matrix>
std::vector<float> to_floats(const Matrix& matrix) {
  std::vector<float> floats(matrix.size());
  std::transform(matrix.data(), matrix.data() + matrix.size(), floats.begin(),
                 [](double x) { return static_cast<float>(x); });
  return floats;
}

/// Halves the coordinates before adding them, so that the sum of two large ones does not overflow.
void place(const Points& points, DrawableMesh& mesh) {
  mesh.centre = points.colwise().minCoeff() / 2 + points.colwise().maxCoeff() / 2;
  mesh.positions = to_floats(Points(points.rowwise() - mesh.centre.transpose()));
}

}  // namespace

DrawableMesh drawable(const Cage& cage, const std::vector<int>& cage_faces) {
  DrawableMesh mesh;
  place(cage.vertices, mesh);
  const PolygonMesh connectivity(cage);
  for (int h = 0; h < connectivity.halfedge_count(); ++h) {
    if (h > connectivity.twin(h)) continue;
    mesh.edges.push_back(connectivity.origin(h));
    mesh.edges.push_back(connectivity.target(h));
  }
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int>& face = cage.faces[f];
    for (std::size_t i = 2; i < face.size(); ++i) {
      mesh.faces.push_back(cage_faces.empty() ? static_cast<std::uint32_t>(f) : cage_faces[f]);
      for (const int corner : {face[0], face[i - 1], face[i]}) mesh.triangles.push_back(corner);
    }
  }
  return mesh;
}

DrawableMesh drawable(const LimitMesh& limit) {
  DrawableMesh mesh;
  place(limit.positions, mesh);
  mesh.normals = to_floats(limit.normals);
  mesh.curvatures = to_floats(limit.curvatures);
  mesh.densities = to_floats(limit.densities);
  mesh.triangles.reserve(6 * limit.quads.size());
  for (const auto& [a, b, c, d] : limit.quads) {
    for (const int corner : {a, b, c, a, c, d}) mesh.triangles.push_back(corner);
  }
  const std::size_t patches = limit.cage_faces.size(), each = patches == 0 ? 0 : 2 * limit.quads.size() / patches;
  mesh.faces.reserve(each * patches);
  for (const int face : limit.cage_faces) mesh.faces.insert(mesh.faces.end(), each, face);
  return mesh;
}

}  // namespace umbilic
