// SPDX-License-Identifier: MIT
/// \file
/// Connectivity of a closed oriented polygon mesh, as half-edges.
#pragma once

#include <array>
#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// A half-edge h is named by a face corner: it runs from `origin(h)` to `origin(next(h))` along face `face(h)`. Corners
/// of faces keep the order of the cage.
class PolygonMesh {
 public:
  /// `cage` must have passed `validate`.
  explicit PolygonMesh(const Cage& cage);
  PolygonMesh(int vertex_count, const std::vector<std::vector<int>>& faces);
  static PolygonMesh of_quads(int vertex_count, const std::vector<std::array<int, 4>>& quads);

  int vertex_count() const { return static_cast<int>(outgoing_.size()); }
  int face_count() const { return static_cast<int>(first_.size()) - 1; }
  int halfedge_count() const { return static_cast<int>(origin_.size()); }
  int edge_count() const { return halfedge_count() / 2; }
  int euler_characteristic() const { return vertex_count() - edge_count() + face_count(); }

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

  int outgoing(int v) const { return outgoing_[v]; }
  int valence(int v) const { return valence_[v]; }
  bool is_extraordinary(int v) const { return valence_[v] != 4; }

 private:
  explicit PolygonMesh(int vertex_count);
  template <class Faces>
  void add(const Faces& faces);
  void connect();

  std::vector<int> first_;     // face -> its first half-edge; one more entry than faces
  std::vector<int> origin_;    // half-edge -> vertex
  std::vector<int> face_;      // half-edge -> face
  std::vector<int> twin_;      // half-edge -> opposite half-edge
  std::vector<int> edge_;      // half-edge -> edge; edges are sorted by their smaller, then their larger vertex
  std::vector<int> outgoing_;  // vertex -> one half-edge that leaves it
  std::vector<int> valence_;   // vertex -> number of edges
};

}  // namespace umbilic
