// SPDX-License-Identifier: MIT
/// \file
/// How the faces of an unchecked polygon mesh meet: edges, orientation, and fans around vertices.
#pragma once

#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// One side of one face.
struct EdgeUse {
  int low = 0;
  int high = 0;  ///< low < high: the two vertices
  int face = 0;
  int corner = 0;        ///< the side goes from this corner of the face to the next
  bool forward = false;  ///< whether it goes from low to high
};

inline bool same_edge(const EdgeUse& a, const EdgeUse& b) { return a.low == b.low && a.high == b.high; }

/// The sides of all faces, sorted so that those of one edge are consecutive. Indices must be in range, and no face may
/// repeat a vertex.
std::vector<EdgeUse> edge_uses(const Cage& cage);

/// Of each use the index of the use on the other side of its edge, or -1 where there is none. No edge may have more
/// than two uses.
std::vector<int> opposite_uses(const std::vector<EdgeUse>& uses);

/// The uses of edges that have a face on one side only, in the order of `uses`.
std::vector<EdgeUse> open_uses(const std::vector<EdgeUse>& uses);

struct Orientation {
  std::vector<int> component;  ///< of each face; components are numbered in the order of their first faces
  std::vector<bool> flipped;   ///< faces to reverse so that neighbours agree; false for the first face of a component
  int component_count = 0;
  int conflict = -1;  ///< a face that cannot be oriented consistently with its neighbours, or -1
};

/// No edge may have more than two uses.
Orientation orient(const Cage& cage, const std::vector<EdgeUse>& uses);

/// Number of fans of faces around each vertex, where faces that share an edge at the vertex belong to the same fan. It
/// is 1 everywhere on a vertex-manifold, and 0 at unused vertices. At an open edge a fan ends. No edge may have more
/// than two uses.
std::vector<int> fan_counts(const Cage& cage, const std::vector<EdgeUse>& uses);

}  // namespace umbilic
