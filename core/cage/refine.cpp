// SPDX-License-Identifier: MIT
/// \file
/// The rules of Catmull & Clark 1978 on lists of faces.
#include "cage/refine.h"

#include <algorithm>
#include <cassert>

#include "cage/edges.h"

namespace umbilic {

namespace {

/// What the rule of a vertex needs to know of its neighbourhood.
struct Neighbourhood {
  int faces = 0;
  Vector3 face_points = Vector3::Zero();  ///< sum
  Vector3 neighbours = Vector3::Zero();   ///< sum
  int boundary_edges = 0;
  Vector3 boundary_neighbours = Vector3::Zero();  ///< sum
};

Vector3 moved(const Vector3& vertex, const Neighbourhood& around) {
  if (around.faces == 0) return vertex;
  if (around.boundary_edges > 0) {
    return around.faces == 1 ? vertex : Vector3((around.boundary_neighbours + 6 * vertex) / 8);
  }
  const int n = around.faces;
  return (around.face_points / n + around.neighbours / n + (n - 2) * vertex) / n;
}

/// The quads of these faces, where those of the face f are numbered from first[f] to before first[f + 1].
std::vector<int> quads_of(const std::vector<int>& faces, const std::vector<int>& first) {
  std::vector<int> quads;
  for (const int f : faces) {
    for (int quad = first[f]; quad < first[f + 1]; ++quad) quads.push_back(quad);
  }
  return quads;
}

}  // namespace

Cage refined(const Cage& cage) {
  const std::vector<EdgeUse> uses = edge_uses(cage);
  const auto vertex_count = static_cast<int>(cage.vertices.rows());
  const auto face_count = static_cast<int>(cage.faces.size());
  const auto point = [&](int v) { return Vector3(cage.vertices.row(v)); };

  std::vector<Vector3> face_points(face_count, Vector3::Zero());
  std::vector<Neighbourhood> around(vertex_count);
  for (int f = 0; f < face_count; ++f) {
    for (const int v : cage.faces[f]) face_points[f] += point(v) / static_cast<double>(cage.faces[f].size());
    for (const int v : cage.faces[f]) {
      ++around[v].faces;
      around[v].face_points += face_points[f];
    }
  }

  std::vector<Vector3> edge_points;
  std::vector<std::vector<int>> edge_of_side(face_count);
  for (int f = 0; f < face_count; ++f) edge_of_side[f].resize(cage.faces[f].size());
  for (std::size_t i = 0; i < uses.size();) {
    const bool inside = i + 1 < uses.size() && same_edge(uses[i], uses[i + 1]);
    const EdgeUse& use = uses[i];
    const Vector3 low = point(use.low), high = point(use.high);
    Vector3 middle = (low + high) / 2;
    if (inside) middle = (2 * middle + face_points[use.face] + face_points[uses[i + 1].face]) / 4;
    for (std::size_t end = i + (inside ? 2 : 1); i < end; ++i) {
      edge_of_side[uses[i].face][uses[i].corner] = vertex_count + static_cast<int>(edge_points.size());
    }
    edge_points.push_back(middle);
    for (const auto& [at, other] : {std::pair(use.low, high), std::pair(use.high, low)}) {
      around[at].neighbours += other;
      if (inside) continue;
      ++around[at].boundary_edges;
      around[at].boundary_neighbours += other;
    }
  }

  Cage result;
  std::vector<int> first{0};
  const auto edge_count = static_cast<int>(edge_points.size());
  result.vertices.resize(vertex_count + edge_count + face_count, 3);
  for (int v = 0; v < vertex_count; ++v) result.vertices.row(v) = moved(point(v), around[v]);
  for (int e = 0; e < edge_count; ++e) result.vertices.row(vertex_count + e) = edge_points[e];
  for (int f = 0; f < face_count; ++f) {
    const int centre = vertex_count + edge_count + f;
    result.vertices.row(centre) = face_points[f];
    const std::vector<int>& sides = edge_of_side[f];
    for (std::size_t i = 0; i < sides.size(); ++i) {
      result.faces.push_back({cage.faces[f][i], sides[i], centre, sides[(i + sides.size() - 1) % sides.size()]});
    }
    first.push_back(static_cast<int>(result.faces.size()));
  }
  result.holes = quads_of(cage.holes, first);
  for (const FaceGroup& group : cage.groups) result.groups.push_back({group.name, quads_of(group.faces, first)});
  return result;
}

}  // namespace umbilic
