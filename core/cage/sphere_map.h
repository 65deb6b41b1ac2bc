// SPDX-License-Identifier: MIT
/// \file
/// Graphs drawn on the unit sphere: what a frame thickens into a cage.
#pragma once

#include <array>
#include <vector>

#include "base/types.h"

namespace umbilic {

/// A junction is a point of the sphere, an arm an arc between two junctions, a tunnel a region that the arcs leave.
/// Around a junction, arms and tunnels alternate; counterclockwise is as seen from outside.
struct SphereMap {
  struct Spoke {
    int arm = 0;
    bool outgoing = false;  ///< the junction is the arm's first end
    int tunnel = 0;         ///< on the spoke's left as it leaves the junction
  };

  std::vector<Vector3> junctions;          ///< unit vectors
  std::vector<Vector3> middles;            ///< the arms' middles, unit vectors
  std::vector<Vector3> tunnels;            ///< directions of the tunnels' centres, unit vectors
  std::vector<std::array<int, 2>> ends;    ///< the arms' junctions
  std::vector<std::vector<Spoke>> spokes;  ///< around each junction, counterclockwise, from its first arm
};

/// N meridians between the poles of the z axis, the first of them through the x axis; N >= 3.
SphereMap hosohedron(int arms);

/// The polyhedron whose vertices, all at one distance from the origin, are joined where they are nearest: uniform
/// polyhedra.
SphereMap uniform_polyhedron(const std::vector<Vector3>& vertices);

/// Angle between `from` and `towards`, unit vectors.
double angle_between(const Vector3& from, const Vector3& towards);

/// The unit tangent at the unit vector `from` that points along the great circle to `towards`.
Vector3 tangent_towards(const Vector3& from, const Vector3& towards);

/// Half the width of the narrowest tunnel, as an angle between an arm's middle and a tunnel's centre.
double narrowest_tunnel(const SphereMap& map);

}  // namespace umbilic
