// SPDX-License-Identifier: MIT
/// \file
/// Marks the faces, and compares held points with their images.
#include "driver/held_faces.h"

#include <algorithm>

#include "mesh/subgroup.h"
#include "problem/face_selection.h"

namespace umbilic {
namespace {

/// By how much an image may differ from its point, relative to the extent of all points.
constexpr double kSamePoint = 1e-12;

/// The surface over a face of a cage depends on two rings of faces around it, where a cap at its rim counts.
constexpr int kRings = 2;

/// Of each vertex: whether it is within kRings rings of a held face.
std::vector<bool> near_held(const std::vector<bool>& held, const PolygonMesh& mesh) {
  std::vector<bool> faces = held, vertices;
  for (int ring = 0; ring <= kRings; ++ring) {
    vertices.assign(mesh.vertex_count(), false);
    for (int h = 0; h < mesh.halfedge_count(); ++h) {
      if (faces[mesh.face(h)]) vertices[mesh.origin(h)] = true;
    }
    for (int h = 0; h < mesh.halfedge_count(); ++h) {
      if (vertices[mesh.origin(h)]) faces[mesh.face(h)] = true;
    }
  }
  return vertices;
}

}  // namespace

Result<std::vector<bool>> held_faces(const Cage& cage, const Constraints& constraints) {
  if (!constraints.holds_faces()) return std::vector<bool>();
  const bool holds = constraints.hold.has_value();
  Result<std::vector<bool>> faces =
      holds ? selected_faces(cage, *constraints.hold, "hold") : selected_faces(cage, *constraints.free, "free");
  if (!faces) return faces.error();
  std::vector<bool> held = std::move(faces).value();
  if (!holds) held.flip();
  const auto count = std::count(held.begin(), held.end(), true);
  if (count == static_cast<std::ptrdiff_t>(held.size()))
    return Error{"constraints: all faces are held; nothing is free"};
  if (count == 0) held.clear();
  return held;
}

SymmetryGroup symmetry_that_keeps(const std::vector<bool>& held, const SymmetryGroup& group, const PolygonMesh& mesh,
                                  const Points& points) {
  const std::vector<bool> near = near_held(held, mesh);
  const double extent = (points.rowwise() - group.center.transpose()).rowwise().norm().maxCoeff();
  return subgroup(group, mesh, [&](const Symmetry& element) {
    for (int f = 0; f < mesh.face_count(); ++f) {
      if (held[image_of_face(mesh, element.map, f)] != held[f]) return false;
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (!near[v]) continue;
      const Vector3 image = group.center + element.isometry * (points.row(v).transpose() - group.center);
      const Vector3 there = points.row(image_of_vertex(mesh, element.map, v));
      if ((image - there).norm() > kSamePoint * extent) return false;
    }
    return true;
  });
}

}  // namespace umbilic
