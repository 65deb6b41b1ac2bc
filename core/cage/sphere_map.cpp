// SPDX-License-Identifier: MIT
/// \file
/// Constructs graphs on the sphere from their junctions and arms.
#include "cage/sphere_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace umbilic {

namespace {

constexpr double kTwoPi = 6.283185307179586;

/// Sorts the arms around each junction. The first arm has angle 0 by definition, so that rounding cannot turn it into 2
/// pi.
void sort_spokes(SphereMap& map) {
  map.spokes.assign(map.junctions.size(), {});
  for (int arm = 0; arm < static_cast<int>(map.ends.size()); ++arm) {
    const std::array<int, 2>& ends = map.ends[arm];
    for (const int end : ends) map.spokes[end].push_back({arm, end == ends[0], -1});
  }
  for (std::size_t j = 0; j < map.junctions.size(); ++j) {
    const Vector3& axis = map.junctions[j];
    std::vector<SphereMap::Spoke>& spokes = map.spokes[j];
    const auto direction = [&](int arm) { return tangent_towards(axis, map.middles[arm]); };
    const int first = spokes.front().arm;
    const Vector3 east = direction(first);
    const auto angle = [&](int arm) {
      if (arm == first) return 0.;
      const Vector3 d = direction(arm);
      const double signed_angle = std::atan2(axis.cross(east).dot(d), east.dot(d));
      return signed_angle < 0 ? signed_angle + kTwoPi : signed_angle;
    };
    std::sort(spokes.begin(), spokes.end(), [&](const auto& a, const auto& b) { return angle(a.arm) < angle(b.arm); });
  }
}

/// Walks around each tunnel with the tunnel on the left: along a spoke, then from its other end along the next spoke
/// clockwise.
void trace_tunnels(SphereMap& map) {
  for (std::size_t start = 0; start < map.junctions.size(); ++start) {
    for (std::size_t first = 0; first < map.spokes[start].size(); ++first) {
      if (map.spokes[start][first].tunnel >= 0) continue;
      Vector3 centre = Vector3::Zero();
      std::size_t junction = start;
      std::size_t k = first;
      do {
        SphereMap::Spoke& spoke = map.spokes[junction][k];
        const int arm = spoke.arm;
        spoke.tunnel = static_cast<int>(map.tunnels.size());
        centre += map.middles[arm];
        junction = map.ends[arm][spoke.outgoing ? 1 : 0];
        const std::vector<SphereMap::Spoke>& next = map.spokes[junction];
        const auto arrival = std::find_if(next.begin(), next.end(), [&](const auto& s) { return s.arm == spoke.arm; });
        k = (arrival - next.begin() + next.size() - 1) % next.size();
      } while (junction != start || k != first);
      map.tunnels.push_back(centre.normalized());
    }
  }
}

}  // namespace

SphereMap hosohedron(int arms) {
  SphereMap map;
  map.junctions = {Vector3::UnitZ(), -Vector3::UnitZ()};
  for (int k = 0; k < arms; ++k) {
    const double angle = kTwoPi * k / arms;
    map.middles.emplace_back(std::cos(angle), std::sin(angle), 0);
    map.ends.push_back({0, 1});
  }
  sort_spokes(map);
  trace_tunnels(map);
  return map;
}

SphereMap uniform_polyhedron(const std::vector<Vector3>& vertices) {
  SphereMap map;
  for (const Vector3& vertex : vertices) map.junctions.push_back(vertex.normalized());
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (vertices[i] - vertices[j]).norm());
  }
  constexpr double kSlack = 1 + 1e-9;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      if ((vertices[i] - vertices[j]).norm() > kSlack * nearest) continue;
      map.ends.push_back({static_cast<int>(i), static_cast<int>(j)});
      map.middles.push_back((map.junctions[i] + map.junctions[j]).normalized());
    }
  }
  sort_spokes(map);
  trace_tunnels(map);
  return map;
}

double angle_between(const Vector3& from, const Vector3& towards) {
  return std::atan2(from.cross(towards).norm(), from.dot(towards));
}

Vector3 tangent_towards(const Vector3& from, const Vector3& towards) {
  return (towards - from.dot(towards) * from).normalized();
}

double narrowest_tunnel(const SphereMap& map) {
  double width = kTwoPi;
  for (std::size_t j = 0; j < map.junctions.size(); ++j) {
    for (const SphereMap::Spoke& spoke : map.spokes[j]) {
      width = std::min(width, angle_between(map.middles[spoke.arm], map.tunnels[spoke.tunnel]));
    }
  }
  return width;
}

}  // namespace umbilic
