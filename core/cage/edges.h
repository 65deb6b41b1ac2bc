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
  int corner = 0;        ///< the side runs from this corner of the face to the next
  bool forward = false;  ///< it runs from low to high
};

inline bool same_edge(const EdgeUse& a, const EdgeUse& b) { return a.low == b.low && a.high == b.high; }

/// The sides of all faces, those of one edge together. Needs indices in range and no face that repeats a vertex.
std::vector<EdgeUse> edge_uses(const Cage& cage);

struct Orientation {
  std::vector<int> component;  ///< of each face, numbered by first face
  std::vector<bool> flipped;   ///< faces to reverse so that neighbours agree; false for the first face of a component
  int component_count = 0;
  int conflict = -1;  ///< a face that no choice can make agree with its neighbours, or -1
};

/// Needs exactly two uses of each edge.
Orientation orient(const Cage& cage, const std::vector<EdgeUse>& uses);

/// Number of fans of faces around each vertex, where faces that share an edge at the vertex are in one fan; 1
/// everywhere on a vertex-manifold, 0 at unused vertices. Needs exactly two uses of each edge.
std::vector<int> fan_counts(const Cage& cage, const std::vector<EdgeUse>& uses);

}  // namespace umbilic
