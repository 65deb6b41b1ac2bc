// SPDX-License-Identifier: MIT
/// \file
/// Pairs half-edges that have the same end points, by a counting sort on the smaller vertex and a sort on the larger;
/// and closes what is open.
#include "mesh/polygon_mesh.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace umbilic {

namespace {

/// The faces without the holes, then the holes.
std::vector<std::vector<int>> holes_last(const Cage& cage) {
  std::vector<bool> is_hole(cage.faces.size(), false);
  for (const int f : cage.holes) is_hole[f] = true;
  std::vector<std::vector<int>> faces;
  faces.reserve(cage.faces.size());
  for (const bool holes : {false, true}) {
    for (std::size_t f = 0; f < cage.faces.size(); ++f) {
      if (is_hole[f] == holes) faces.push_back(cage.faces[f]);
    }
  }
  return faces;
}

}  // namespace

PolygonMesh::PolygonMesh(const Cage& cage) : PolygonMesh(static_cast<int>(cage.vertices.rows())) {
  if (cage.holes.empty()) {
    add(cage.faces);
  } else {
    add(holes_last(cage));
    surface_count_ -= static_cast<int>(cage.holes.size());
  }
  close();
}

PolygonMesh::PolygonMesh(int vertex_count) : outgoing_(vertex_count, -1), valence_(vertex_count, 0) {}

PolygonMesh::PolygonMesh(int vertex_count, const std::vector<std::vector<int>>& faces) : PolygonMesh(vertex_count) {
  add(faces);
  close();
}

PolygonMesh PolygonMesh::of_quads(int vertex_count, const std::vector<std::array<int, 4>>& quads) {
  return of_quads(vertex_count, quads, static_cast<int>(quads.size()));
}

PolygonMesh PolygonMesh::of_quads(int vertex_count, const std::vector<std::array<int, 4>>& quads, int surface_count) {
  PolygonMesh mesh(vertex_count);
  mesh.add(quads);
  mesh.surface_count_ = surface_count;
  mesh.close();
  return mesh;
}

template <class Faces>
void PolygonMesh::add(const Faces& faces) {
  first_.reserve(faces.size() + 1);
  if (first_.empty()) first_.push_back(0);
  for (const auto& corners : faces) {
    origin_.insert(origin_.end(), corners.begin(), corners.end());
    face_.insert(face_.end(), corners.size(), static_cast<int>(first_.size()) - 1);
    first_.push_back(static_cast<int>(origin_.size()));
  }
  surface_count_ = outer_begin_ = static_cast<int>(first_.size()) - 1;
}

void PolygonMesh::close() {
  int open = connect();
  if (open == 0) return;
  std::vector<std::vector<int>> outer;
  std::vector<bool> closed(halfedge_count(), false);
  for (int first = 0; first < halfedge_count(); ++first) {
    if (twin_[first] >= 0 || closed[first]) continue;
    outer.emplace_back();
    for (int h = first; !closed[h];) {
      closed[h] = true;
      outer.back().push_back(target(h));
      for (h = previous(h); twin_[h] >= 0; h = previous(twin_[h])) {
      }
    }
  }
  const int surface = surface_count_, ghosts_end = outer_begin_;
  add(outer);
  surface_count_ = surface;
  outer_begin_ = ghosts_end;
  std::fill(outgoing_.begin(), outgoing_.end(), -1);
  std::fill(valence_.begin(), valence_.end(), 0);
  open = connect();
  assert(open == 0);
}

int PolygonMesh::euler_characteristic() const {
  if (!is_open()) return vertex_count() - edge_count() + face_count();
  int characteristic = surface_count_;
  for (int v = 0; v < vertex_count(); ++v) characteristic += on_surface(v);
  for (int h = 0; h < surface_halfedge_count(); ++h) characteristic -= h < twin_[h];
  return characteristic;
}

int PolygonMesh::connect() {
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
  twin_.assign(count, -1);
  edge_.assign(count, -1);
  int edges = 0, open = 0;
  for (int i = 0; i < count; ++edges) {
    const int h = sorted[i++];
    if (i == count || std::minmax(origin(h), target(h)) != std::minmax(origin(sorted[i]), target(sorted[i]))) {
      ++open;
      continue;
    }
    const int t = sorted[i++];
    assert(origin(h) == target(t) && target(h) == origin(t));
    twin_[h] = t;
    twin_[t] = h;
    edge_[h] = edge_[t] = edges;
  }
  return open;
}

}  // namespace umbilic
