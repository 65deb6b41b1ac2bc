// SPDX-License-Identifier: MIT
/// \file
/// Pairs half-edges that have the same end points, by a counting sort on the smaller vertex and a sort on the larger.
#include "mesh/polygon_mesh.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace umbilic {

PolygonMesh::PolygonMesh(const Cage& cage) : PolygonMesh(static_cast<int>(cage.vertices.rows()), cage.faces) {}

PolygonMesh::PolygonMesh(int vertex_count) : outgoing_(vertex_count, -1), valence_(vertex_count, 0) {}

PolygonMesh::PolygonMesh(int vertex_count, const std::vector<std::vector<int>>& faces) : PolygonMesh(vertex_count) {
  add(faces);
}

PolygonMesh PolygonMesh::of_quads(int vertex_count, const std::vector<std::array<int, 4>>& quads) {
  PolygonMesh mesh(vertex_count);
  mesh.add(quads);
  return mesh;
}

template <class Faces>
void PolygonMesh::add(const Faces& faces) {
  first_.reserve(faces.size() + 1);
  first_.push_back(0);
  for (const auto& corners : faces) {
    origin_.insert(origin_.end(), corners.begin(), corners.end());
    face_.insert(face_.end(), corners.size(), static_cast<int>(first_.size()) - 1);
    first_.push_back(static_cast<int>(origin_.size()));
  }
  connect();
}

void PolygonMesh::connect() {
  const int count = halfedge_count();
  std::vector<int> end(vertex_count() + 1, 0), sorted(count);
  for (int h = 0; h < count; ++h) {
    outgoing_[origin(h)] = outgoing_[origin(h)] < 0 ? h : outgoing_[origin(h)];
    ++valence_[origin(h)];
    ++end[std::min(origin(h), target(h)) + 1];
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  // While it is being filled, end[v] is where the next half-edge of v goes; it starts at the first.
  for (int h = 0; h < count; ++h) sorted[end[std::min(origin(h), target(h))]++] = h;
  const auto by_larger_end = [&](int a, int b) {
    return std::pair(std::max(origin(a), target(a)), a) < std::pair(std::max(origin(b), target(b)), b);
  };
  for (int v = 0, begin = 0; v < vertex_count(); begin = end[v++]) {
    std::sort(sorted.begin() + begin, sorted.begin() + end[v], by_larger_end);
  }
  twin_.resize(count);
  edge_.resize(count);
  for (int i = 0; i + 1 < count; i += 2) {
    const int h = sorted[i], t = sorted[i + 1];
    assert(origin(h) == target(t) && target(h) == origin(t));
    twin_[h] = t;
    twin_[t] = h;
    edge_[h] = edge_[t] = i / 2;
  }
}

}  // namespace umbilic
