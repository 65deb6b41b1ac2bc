// SPDX-License-Identifier: MIT
/// \file
/// Graphs drawn on the unit sphere, which frames thicken into cages.
#pragma once

#include <array>
#include <vector>

#include "base/types.h"

namespace umbilic {

/// A junction is a point of the sphere, an arm is an arc between two junctions, and a tunnel is a region between the
/// arcs. Arms and tunnels alternate around a junction; counterclockwise means as seen from outside.
struct SphereMap {
  struct Spoke {
    int arm = 0;
    bool outgoing = false;  ///< whether the junction is the arm's first end
    int tunnel = 0;         ///< the tunnel to the left of the spoke, seen from the junction
  };

  std::vector<Vector3> junctions;          ///< unit vectors
  std::vector<Vector3> middles;            ///< the arms' middles, unit vectors
  std::vector<Vector3> tunnels;            ///< directions of the tunnels' centres, unit vectors
  std::vector<std::array<int, 2>> ends;    ///< the arms' junctions
  std::vector<std::vector<Spoke>> spokes;  ///< around each junction, counterclockwise, from its first arm
};

/// N >= 3 meridians between the poles of the z axis; the first one crosses the x axis.
SphereMap hosohedron(int arms);

/// The graph of a uniform polyhedron. All vertices must have the same distance from the origin; nearest neighbours are
/// joined.
SphereMap uniform_polyhedron(const std::vector<Vector3>& vertices);

/// Angle between `from` and `towards`, unit vectors.
double angle_between(const Vector3& from, const Vector3& towards);

/// The unit tangent at the unit vector `from` that points along the great circle to `towards`.
Vector3 tangent_towards(const Vector3& from, const Vector3& towards);

/// Half the width of the narrowest tunnel, measured as the angle between an arm's middle and a tunnel's centre.
double narrowest_tunnel(const SphereMap& map);

}  // namespace umbilic
