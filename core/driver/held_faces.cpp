// SPDX-License-Identifier: MIT
/// \file
/// Marks the faces, and compares held points with their images.
#include "driver/held_faces.h"

#include <algorithm>

#include "mesh/automorphism.h"
#include "problem/face_selection.h"

namespace umbilic {
namespace {

/// By how much an image may differ from its point, relative to the extent of all points.
constexpr double kSamePoint = 1e-12;

/// The surface over a face of a cage depends on two rings of faces around it, where a cap at its rim counts.
constexpr int kRings = 2;

/// Of each vertex: whether it is within kRings rings of a held face or of a face at a held boundary.
std::vector<bool> near_held(const std::vector<bool>& held, const std::vector<BoundaryCondition>& boundary,
                            const PolygonMesh& mesh) {
  std::vector<bool> faces = held, vertices;
  faces.resize(mesh.face_count(), false);
  for (std::size_t h = 0; h < boundary.size(); ++h) {
    const int here = static_cast<int>(h);
    if (mesh.is_boundary(here) && boundary[h] != BoundaryCondition::kFree) faces[mesh.face(here)] = true;
  }
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

std::vector<bool> images_of_faces(const std::vector<bool>& selected, const std::vector<Symmetry>& symmetries,
                                  const PolygonMesh& mesh) {
  std::vector<bool> images(selected.size(), false);
  for (std::size_t f = 0; f < selected.size(); ++f) {
    if (!selected[f]) continue;
    for (const Symmetry& symmetry : symmetries) images[image_of_face(mesh, symmetry.map, static_cast<int>(f))] = true;
  }
  return images;
}

HeldFaces::HeldFaces(const std::vector<bool>& held, const std::vector<BoundaryCondition>& boundary,
                     const PolygonMesh& mesh, const Points& points)
    : held_(held), boundary_(boundary), mesh_(mesh), points_(points) {
  if (held.empty() && boundary.empty()) return;
  near_ = near_held(held, boundary, mesh);
  largest_difference_ = kSamePoint * (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

bool HeldFaces::kept_by(const Symmetry& symmetry, const Vector3& center) const {
  for (int h = 0; h < static_cast<int>(boundary_.size()); ++h) {
    if (!mesh_.is_boundary(h)) continue;
    const int image = symmetry.map.halfedges[h];
    if (!mesh_.is_boundary(image) || boundary_[image] != boundary_[h]) return false;
  }
  for (int f = 0; f < static_cast<int>(held_.size()); ++f) {
    if (held_[image_of_face(mesh_, symmetry.map, f)] != held_[f]) return false;
  }
  for (int v = 0; v < static_cast<int>(near_.size()); ++v) {
    if (!near_[v]) continue;
    const Vector3 image = center + symmetry.isometry * (points_.row(v).transpose() - center);
    const Vector3 there = points_.row(image_of_vertex(mesh_, symmetry.map, v));
    if ((image - there).norm() > largest_difference_) return false;
  }
  return true;
}

}  // namespace umbilic
