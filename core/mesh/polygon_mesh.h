// SPDX-License-Identifier: MIT
/// \file
/// Connectivity of an oriented polygon mesh, as half-edges. It is closed, even where the surface is open.
///
/// An open surface, or one with holes, needs control points on both sides of its boundary. So its mesh has faces of
/// three roles, numbered in this order:
///   surface: the faces whose limit is the surface;
///   ghost: faces that take part in subdivision, but carry no surface. One ring of them around each boundary is enough;
///   outer: one polygon of any size for each loop that surface and ghosts leave open. It is never subdivided: it only
///     gives every half-edge a twin.
/// An edge is a boundary edge if it has the surface on one side only, and a vertex is on the surface if some face at it
/// is. How the mesh of an open cage gets its ghosts is told in mesh/ghosts.h.
#pragma once

#include <array>
#include <vector>

#include "cage/cage.h"

namespace umbilic {

enum class FaceRole : char { kSurface, kGhost, kOuter };

/// A half-edge h is named by a face corner: it runs from `origin(h)` to `origin(next(h))` along face `face(h)`. Corners
/// of faces keep the order of the cage.
class PolygonMesh {
 public:
  /// `cage` must have passed `validate`. Its vertices keep their numbers, also those that only holes use. Its holes are
  /// the ghosts; the other faces keep their order.
  explicit PolygonMesh(const Cage& cage);
  PolygonMesh(int vertex_count, const std::vector<std::vector<int>>& faces);
  static PolygonMesh of_quads(int vertex_count, const std::vector<std::array<int, 4>>& quads);
  /// The first `surface_count` quads are the surface, the others ghosts. Adds the outer faces: walking around one, the
  /// next edge is the next open edge of the same fan, so that each fan of a vertex without surface is closed by itself.
  static PolygonMesh of_quads(int vertex_count, const std::vector<std::array<int, 4>>& quads, int surface_count);

  int vertex_count() const { return static_cast<int>(outgoing_.size()); }
  int face_count() const { return static_cast<int>(first_.size()) - 1; }
  int halfedge_count() const { return static_cast<int>(origin_.size()); }
  int edge_count() const { return halfedge_count() / 2; }
  /// Of the surface.
  int euler_characteristic() const;

  /// Whether some faces are not surface.
  bool is_open() const { return surface_count_ < face_count(); }
  FaceRole role(int f) const {
    return f < surface_count_ ? FaceRole::kSurface : f < outer_begin_ ? FaceRole::kGhost : FaceRole::kOuter;
  }
  bool is_surface(int f) const { return f < surface_count_; }
  int surface_face_count() const { return surface_count_; }
  int ghost_face_count() const { return outer_begin_ - surface_count_; }
  /// Half-edges of the surface's faces are numbered before all others.
  int surface_halfedge_count() const { return first_[surface_count_]; }
  bool on_surface(int v) const { return outgoing_[v] >= 0 && outgoing_[v] < surface_halfedge_count(); }
  /// Whether the half-edge has the surface on its left and none on its right.
  bool is_boundary(int h) const { return is_surface(face_[h]) && !is_surface(face_[twin_[h]]); }

  int face_size(int f) const { return first_[f + 1] - first_[f]; }
  int halfedge(int f, int corner) const { return first_[f] + corner; }

  int origin(int h) const { return origin_[h]; }
  int target(int h) const { return origin_[next(h)]; }
  int face(int h) const { return face_[h]; }
  int twin(int h) const { return twin_[h]; }
  int edge(int h) const { return edge_[h]; }
  int next(int h) const { return h + 1 == first_[face_[h] + 1] ? first_[face_[h]] : h + 1; }
  int previous(int h) const { return h == first_[face_[h]] ? first_[face_[h] + 1] - 1 : h - 1; }
  /// The next half-edge out of the same vertex, counterclockwise as seen from outside.
  int rotate(int h) const { return twin_[previous(h)]; }

  /// A half-edge of the surface if the vertex is on it.
  int outgoing(int v) const { return outgoing_[v]; }
  int valence(int v) const { return valence_[v]; }
  bool is_extraordinary(int v) const { return valence_[v] != 4; }

 private:
  explicit PolygonMesh(int vertex_count);
  template <class Faces>
  void add(const Faces& faces);
  /// Pairs half-edges; those without partner get twin and edge -1, and are counted.
  int connect();
  /// Adds the outer faces.
  void close();

  int surface_count_ = 0, outer_begin_ = 0;
  std::vector<int> first_;     // face -> its first half-edge; one more entry than faces
  std::vector<int> origin_;    // half-edge -> vertex
  std::vector<int> face_;      // half-edge -> face
  std::vector<int> twin_;      // half-edge -> opposite half-edge
  std::vector<int> edge_;      // half-edge -> edge; edges are sorted by their smaller, then their larger vertex
  std::vector<int> outgoing_;  // vertex -> one half-edge that leaves it
  std::vector<int> valence_;   // vertex -> number of edges
};

}  // namespace umbilic
