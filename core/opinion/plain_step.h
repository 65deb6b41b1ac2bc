// SPDX-License-Identifier: MIT
/// \file
/// One Catmull-Clark step of a closed cage as the paper of 1978 words it: face points, edge points, vertex points,
/// found through maps of vertex pairs. It shares nothing with the half-edge mesh.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "cage/cage.h"

namespace umbilic::opinion {

struct PlainStep {
  std::vector<Vector3> vertex_points, face_points;
  std::map<std::pair<int, int>, Vector3> edge_points;  ///< by the edge's vertices, the lower first
};

PlainStep plain_step(const Cage& cage);

/// The refined cage: the vertices are those of the vertices, then edges (sorted), then faces; each corner of a face has
/// a quad, from the corner along its edge.
Cage refined(const Cage& cage);

}  // namespace umbilic::opinion
