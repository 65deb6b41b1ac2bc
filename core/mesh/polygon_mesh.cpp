// SPDX-License-Identifier: MIT
/// \file
/// Pairs half-edges by sorting their undirected end points.
#include "mesh/polygon_mesh.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace umbilic {

PolygonMesh::PolygonMesh(const Cage& cage) : PolygonMesh(static_cast<int>(cage.vertices.rows()), cage.faces) {}

PolygonMesh::PolygonMesh(int vertex_count, const std::vector<std::vector<int>>& faces)
    : outgoing_(vertex_count, -1), valence_(vertex_count, 0) {
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
  std::vector<std::pair<std::pair<int, int>, int>> ends(count);
  for (int h = 0; h < count; ++h) {
    ends[h] = {std::minmax(origin(h), target(h)), h};
    outgoing_[origin(h)] = outgoing_[origin(h)] < 0 ? h : outgoing_[origin(h)];
    ++valence_[origin(h)];
  }
  std::sort(ends.begin(), ends.end());
  twin_.resize(count);
  edge_.resize(count);
  for (int i = 0; i + 1 < count; i += 2) {
    const int h = ends[i].second, t = ends[i + 1].second;
    assert(ends[i].first == ends[i + 1].first && origin(h) == target(t));
    twin_[h] = t;
    twin_[t] = h;
    edge_[h] = edge_[t] = i / 2;
  }
}

}  // namespace umbilic
