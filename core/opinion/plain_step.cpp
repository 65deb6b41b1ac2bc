// SPDX-License-Identifier: MIT
/// \file
/// Averages points.
#include "opinion/plain_step.h"

#include <algorithm>
#include <cstddef>

namespace umbilic::opinion {

PlainStep plain_step(const Cage& cage) {
  PlainStep result;
  const auto at = [&](int v) -> Vector3 { return cage.vertices.row(v).transpose(); };
  std::map<std::pair<int, int>, std::vector<Vector3>> beside;      // edge -> face points of its faces
  std::vector<std::vector<Vector3>> around(cage.vertices.rows());  // vertex -> face points of its faces
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
  std::vector<std::vector<Vector3>> midpoints(cage.vertices.rows());  // vertex -> midpoints of its edges
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

Cage refined(const Cage& cage) {
  const PlainStep step = plain_step(cage);
  std::map<std::pair<int, int>, int> number;  // of the edge points
  Cage result;
  const auto vertices = static_cast<int>(step.vertex_points.size()), edges = static_cast<int>(step.edge_points.size());
  result.vertices.resize(vertices + edges + static_cast<int>(step.face_points.size()), 3);
  int row = 0;
  for (const Vector3& point : step.vertex_points) result.vertices.row(row++) = point.transpose();
  for (const auto& [edge, point] : step.edge_points) {
    number[edge] = row;
    result.vertices.row(row++) = point.transpose();
  }
  for (const Vector3& point : step.face_points) result.vertices.row(row++) = point.transpose();
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int>& face = cage.faces[f];
    const auto edge = [&](std::size_t i) {
      return number.at(std::minmax(face[i % face.size()], face[(i + 1) % face.size()]));
    };
    for (std::size_t i = 0; i < face.size(); ++i) {
      result.faces.push_back({face[i], edge(i), vertices + edges + static_cast<int>(f), edge(i + face.size() - 1)});
    }
  }
  return result;
}

}  // namespace umbilic::opinion
