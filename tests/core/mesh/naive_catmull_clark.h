// SPDX-License-Identifier: MIT
/// \file
/// Catmull-Clark as the paper of 1978 words it: face points, edge points, vertex points, found through maps of vertex
/// pairs. A second implementation that shares nothing with the half-edge mesh.
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "cage/cage.h"

namespace umbilic::test {

struct NaiveRefinement {
  std::vector<Vector3> vertex_points, face_points;
  std::map<std::pair<int, int>, Vector3> edge_points;  ///< by the edge's vertices, the lower first
};

inline NaiveRefinement naive_catmull_clark(const Cage& cage) {
  NaiveRefinement result;
  const auto at = [&](int v) -> Vector3 { return cage.vertices.row(v).transpose(); };
  std::map<std::pair<int, int>, std::vector<Vector3>> beside;  // edge -> face points of its faces
  std::map<int, std::vector<Vector3>> around;                  // vertex -> face points of its faces
  for (const std::vector<int>& face : cage.faces) {
    Vector3 sum = Vector3::Zero();
    for (const int v : face) sum += at(v);
    const Vector3 point = sum / static_cast<double>(face.size());
    result.face_points.push_back(point);
    for (std::size_t i = 0; i < face.size(); ++i) {
      beside[std::minmax(face[i], face[(i + 1) % face.size()])].push_back(point);
      around[face[i]].push_back(point);
    }
  }
  std::map<int, std::vector<Vector3>> midpoints;  // vertex -> midpoints of its edges
  for (const auto& [edge, points] : beside) {
    const Vector3 ends = at(edge.first) + at(edge.second);
    result.edge_points[edge] = (ends + points.at(0) + points.at(1)) / 4;
    midpoints[edge.first].push_back(ends / 2);
    midpoints[edge.second].push_back(ends / 2);
  }
  const auto mean = [](const std::vector<Vector3>& points) {
    Vector3 sum = Vector3::Zero();
    for (const Vector3& p : points) sum += p;
    return Vector3(sum / static_cast<double>(points.size()));
  };
  for (int v = 0; v < cage.vertices.rows(); ++v) {
    const double n = static_cast<double>(around[v].size());
    result.vertex_points.push_back(mean(around[v]) / n + 2 * mean(midpoints[v]) / n + (n - 3) / n * at(v));
  }
  return result;
}

}  // namespace umbilic::test
