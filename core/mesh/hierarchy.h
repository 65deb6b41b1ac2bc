// SPDX-License-Identifier: MIT
/// \file
/// At which refinement of a cage the limit surface can be evaluated.
#pragma once

#include "base/result.h"
#include "mesh/subdivision.h"

namespace umbilic {

inline constexpr int kMinValence = 3;
inline constexpr int kMaxValence = 24;

/// Whether every face is a quad with at most one extraordinary vertex; of an open surface, every face of the surface,
/// and whether every vertex of it has all its ghosts.
bool is_evaluable(const PolygonMesh& mesh);

/// The smallest number of Catmull-Clark steps after which the mesh is evaluable: 0, 1 or 2.
/// Fails on a vertex of valence 2 and on a vertex or a face of more than kMaxValence edges, and names it. A vertex on a
/// bare boundary may have 1 to kMaxValence / 2 faces, since its ghosts double its valence. Fails on a vertex where
/// holes separate several fans of the surface.
Result<int> required_level(const PolygonMesh& mesh);

}  // namespace umbilic
