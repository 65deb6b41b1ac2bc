// SPDX-License-Identifier: MIT
/// \file
/// Computes the cages of frames, point by point.
///
///     words        | code
///     -------------|------------------------------------------------------------------------------------
///     axis point   | junction J, on the layer +h (outer) or −h (inner)
///     arm point    | arm's middle M, on the layer +h or −h
///     side of arm  | M + l (T' − M), where l = h / |T' − M|
///     crotch       | J + l (T' − J): where the sides of two neighbouring arms meet
#include "cage/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbilic {

namespace {

using Spoke = SphereMap::Spoke;

/// Places points on the layers of a frame and numbers them.
class FrameBuilder {
 public:
  FrameBuilder(const SphereMap& map, const FrameShape& shape, double half_width)
      : map_(map), spread_(shape.spread), half_width_(half_width / shape.spread) {}

  int add(const Vector3& point, double layer) {
    const Vector3 axes(spread_ + layer, spread_ + layer, 1 + layer);
    positions_.push_back(axes.cwiseProduct(point));
    return static_cast<int>(positions_.size()) - 1;
  }

  void add_face(std::vector<int> face) { faces_.push_back(std::move(face)); }

  Vector3 side(int arm, int tunnel) const { return towards_tunnel(map_.middles[arm], arm, tunnel); }

  Vector3 crotch(std::size_t junction, const Spoke& spoke) const {
    return towards_tunnel(map_.junctions[junction], spoke.arm, spoke.tunnel);
  }

  Cage finish() && {
    Cage cage;
    cage.vertices.resize(static_cast<Eigen::Index>(positions_.size()), 3);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      cage.vertices.row(static_cast<Eigen::Index>(i)) = positions_[i].transpose();
    }
    cage.faces = std::move(faces_);
    return cage;
  }

 private:
  Vector3 towards_tunnel(const Vector3& from, int arm, int tunnel) const {
    const double half_tunnel = angle_between(map_.middles[arm], map_.tunnels[tunnel]);
    const Vector3 above = map_.tunnels[tunnel] / std::cos(half_tunnel);
    return from + half_width_ / std::tan(half_tunnel) * (above - from);
  }

  const SphereMap& map_;
  double spread_;
  double half_width_;
  std::vector<Vector3> positions_;
  std::vector<std::vector<int>> faces_;
};

/// The tunnels on the left and right of each arm, seen from its first end.
std::vector<std::array<int, 2>> tunnels_of_arms(const SphereMap& map) {
  std::vector<std::array<int, 2>> tunnels(map.ends.size());
  for (const std::vector<Spoke>& spokes : map.spokes) {
    for (const Spoke& spoke : spokes) tunnels[spoke.arm][spoke.outgoing ? 0 : 1] = spoke.tunnel;
  }
  return tunnels;
}

/// Calls `visit(junction, spoke, left corner, right corner)` for each spoke; corner k of a junction lies to the left of
/// spoke k.
template <class Visit>
void for_each_spoke(const SphereMap& map, Visit visit) {
  for (std::size_t j = 0; j < map.spokes.size(); ++j) {
    const std::size_t n = map.spokes[j].size();
    for (std::size_t k = 0; k < n; ++k) visit(j, map.spokes[j][k], k, (k + n - 1) % n);
  }
}

}  // namespace

Result<FrameShape> frame_shape(const SphereMap& map, const CageOptions& options) {
  constexpr double kThinnest = 0.01;
  constexpr double kFlattest = 0.5;
  constexpr double kWidest = 3;
  if (!(options.spread >= kFlattest && options.spread <= kWidest)) {
    return Error{fmt::format("spread {} is not between {} and {}", options.spread, kFlattest, kWidest)};
  }
  const double room = std::min(1., options.spread);
  const double tunnel = std::tan(narrowest_tunnel(map));  // from an arm's middle to the point above the tunnel's centre
  const double standard = room * std::min(1. / 3, tunnel / 2);
  // An arm may fill 0.85 of its half of the tunnel, and 0.75 of the distance to the frame's centre.
  const double thickest = std::min(0.85 * options.spread * tunnel, 0.75 * room) / standard;
  const double allowed = std::floor(100 * thickest) / 100;
  if (!(options.thickness >= kThinnest && options.thickness <= allowed)) {
    return Error{fmt::format("thickness {} is not between {} and {}", options.thickness, kThinnest, allowed)};
  }
  return FrameShape{options.spread, options.thickness * standard};
}

Cage hub_frame(const SphereMap& map, const FrameShape& shape) {
  const double h = shape.half_width / std::sqrt(2.);
  FrameBuilder build(map, shape, h);
  struct Layers {
    int outer, inner;
  };
  const auto add = [&](const Vector3& direction) { return Layers{build.add(direction, h), build.add(direction, -h)}; };

  std::vector<std::vector<Layers>> corner(map.junctions.size());
  for (std::size_t j = 0; j < map.junctions.size(); ++j) {
    for (const Spoke& spoke : map.spokes[j]) corner[j].push_back(add(build.crotch(j, spoke)));
  }
  std::vector<std::array<Layers, 2>> side;
  const std::vector<std::array<int, 2>> tunnels = tunnels_of_arms(map);
  for (std::size_t arm = 0; arm < tunnels.size(); ++arm) {
    const auto a = static_cast<int>(arm);
    const Layers left = add(build.side(a, tunnels[arm][0]));
    side.push_back({left, add(build.side(a, tunnels[arm][1]))});
  }

  for (const std::vector<Layers>& corners : corner) {
    std::vector<int> outer;
    for (const Layers& c : corners) outer.push_back(c.outer);
    std::vector<int> inner;
    for (auto c = corners.rbegin(); c != corners.rend(); ++c) inner.push_back(c->inner);
    build.add_face(std::move(outer));
    build.add_face(std::move(inner));
  }
  for_each_spoke(map, [&](std::size_t j, const Spoke& spoke, std::size_t left, std::size_t right) {
    const Layers cl = corner[j][left];
    const Layers cr = corner[j][right];
    const Layers sl = side[spoke.arm][spoke.outgoing ? 0 : 1];
    const Layers sr = side[spoke.arm][spoke.outgoing ? 1 : 0];
    build.add_face({cr.outer, sr.outer, sl.outer, cl.outer});
    build.add_face({cl.inner, sl.inner, sr.inner, cr.inner});
    build.add_face({cl.outer, sl.outer, sl.inner, cl.inner});
    build.add_face({sr.outer, cr.outer, cr.inner, sr.inner});
  });
  return std::move(build).finish();
}

Cage flag_frame(const SphereMap& map, const FrameShape& shape) {
  const double h = shape.half_width;
  FrameBuilder build(map, shape, h);
  struct Junction {
    int outer, inner;
    std::vector<int> crotch;
  };
  struct Arm {
    int outer, inner;
    std::array<int, 2> side;
  };

  std::vector<Junction> junctions;
  for (std::size_t j = 0; j < map.junctions.size(); ++j) {
    const int outer = build.add(map.junctions[j], h);
    junctions.push_back({outer, build.add(map.junctions[j], -h), {}});
    for (const Spoke& spoke : map.spokes[j]) {
      junctions.back().crotch.push_back(build.add(build.crotch(j, spoke), 0));
    }
  }
  std::vector<Arm> arms;
  const std::vector<std::array<int, 2>> tunnels = tunnels_of_arms(map);
  for (std::size_t arm = 0; arm < tunnels.size(); ++arm) {
    const auto a = static_cast<int>(arm);
    const int outer = build.add(map.middles[arm], h);
    const int inner = build.add(map.middles[arm], -h);
    const int left = build.add(build.side(a, tunnels[arm][0]), 0);
    arms.push_back({outer, inner, {left, build.add(build.side(a, tunnels[arm][1]), 0)}});
  }

  for_each_spoke(map, [&](std::size_t j, const Spoke& spoke, std::size_t left, std::size_t right) {
    const Junction& axis = junctions[j];
    const Arm& arm = arms[spoke.arm];
    const int side_left = arm.side[spoke.outgoing ? 0 : 1];
    const int side_right = arm.side[spoke.outgoing ? 1 : 0];
    build.add_face({axis.outer, arm.outer, side_left, axis.crotch[left]});
    build.add_face({axis.crotch[left], side_left, arm.inner, axis.inner});
    build.add_face({axis.outer, axis.crotch[right], side_right, arm.outer});
    build.add_face({axis.inner, arm.inner, side_right, axis.crotch[right]});
  });
  return std::move(build).finish();
}

}  // namespace umbilic
