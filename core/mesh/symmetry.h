// SPDX-License-Identifier: MIT
/// \file
/// The symmetry group of a cage, found from its connectivity and its points, and the orbits of its faces.
#pragma once

#include <string>
#include <vector>

#include "base/types.h"
#include "mesh/automorphism.h"
#include "mesh/orbits.h"

namespace umbilic {

/// A cage has a symmetry group where making it exactly symmetric moves no point farther than this, relative to the
/// largest distance of a point from the centroid. Coordinates that are written with four decimals, on a cage of radius
/// 1, are off by up to sqrt(3)/2 1e-4. Deviations of up to half the
/// tolerance keep the group.
inline constexpr double kSymmetryTolerance = 1e-4;

inline constexpr double kSymmetryWork = 1e8, kSymmetryWorkPerHalfedge = 1e3;

/// An isometry of space, x -> center + isometry (x - center), that maps the points of a mesh to one another as `map`
/// maps its vertices.
struct Symmetry {
  Eigen::Matrix3d isometry;  ///< orthogonal to rounding
  Automorphism map;
};

/// A finite group of symmetries of a mesh.
struct SymmetryGroup {
  /// Schoenflies symbol: C1, Ci, Cs, Cn, Cnv, Cnh, S2n, Dn, Dnh, Dnd, T, Td, Th, O, Oh, I or Ih, with a number for n.
  std::string name = "C1";
  int order = 1;
  Vector3 center = Vector3::Zero();  ///< the centroid of the vertices
  /// Each at least doubles the group that those before it generate; empty for C1. Their isometries satisfy the group's
  /// relations to rounding, also where the points have noise.
  std::vector<Symmetry> generators;
  bool complete = true;  ///< false where the search ran out of work (see find_symmetry), so that there may be more
};

/// All isometries that map `mesh` with its `points` to itself, within kSymmetryTolerance. The cage may have several
/// components, which may change places. Where noise admits isometries that do not close up to a group, the answer is
/// a subgroup.
///
/// C1 also stands for cages that determine no finite group, or none that acts without doubt: each component on a line
/// through the centroid, or points that coincide so that a relabelling moves none of them. A symmetry that turns only
/// some components inside out, which needs components that enclose no volume, is not found.
///
/// The search looks at no more than kSymmetryWork + kSymmetryWorkPerHalfedge (number of half-edges) half-edges, which
/// equal components in many equal places would otherwise make grow with the third power of their number. Where that
/// does not suffice the answer is what the symmetries found so far generate, or C1, and not `complete`.
SymmetryGroup find_symmetry(const PolygonMesh& mesh, const Points& points);

/// The same group acting on catmull_clark(mesh).mesh.
SymmetryGroup refined(const SymmetryGroup& group, const PolygonMesh& mesh);

Orbits face_orbits(const PolygonMesh& mesh, const SymmetryGroup& group);

}  // namespace umbilic
