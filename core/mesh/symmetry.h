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

/// A cage has a symmetry if making it exactly symmetric moves no point by more than this, relative to the largest
/// distance of a point from the centroid. (Coordinates with four decimals, on a cage of radius 1, are off by up to
/// sqrt(3)/2 1e-4.) Deviations up to half the tolerance never lose the group.
inline constexpr double kSymmetryTolerance = 1e-4;

/// The search for symmetries looks at no more than kSymmetryWork + kSymmetryWorkPerHalfedge (number of half-edges)
/// half-edges. Without this bound many equal components that coincide would take cubic time.
inline constexpr double kSymmetryWork = 1e8, kSymmetryWorkPerHalfedge = 1e3;

/// An isometry of space, x -> center + isometry (x - center), that maps the points of a mesh as `map` maps its
/// vertices.
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
  /// Each generator at least doubles the group that those before it generate; empty for C1. Their isometries satisfy
  /// the relations of the group to rounding, even if the points are noisy.
  std::vector<Symmetry> generators;
  bool complete = true;  ///< false if the search exceeded its bound on work, so that there may be more
};

/// All isometries that map `mesh` with its `points` to itself, within kSymmetryTolerance. They may exchange components.
/// They keep the roles of faces: surface, ghost, outer.
/// If noise admits isometries that do not form a group, the result is a subgroup.
///
/// The result is C1 for cages with no well-defined finite group: each component lies on a line through the centroid, or
/// so many points coincide that some relabelling moves none. A symmetry that turns only some components inside out is
/// not found; such components would enclose no volume.
///
/// If the search exceeds its bound on work (kSymmetryWork), the result is the group that the symmetries found so far
/// generate, or C1, and it is not `complete`.
SymmetryGroup find_symmetry(const PolygonMesh& mesh, const Points& points);

/// The same group acting on catmull_clark(mesh).mesh.
SymmetryGroup refined(const SymmetryGroup& group, const PolygonMesh& mesh);
/// The same where that mesh is known already: `finer`.
SymmetryGroup refined(const SymmetryGroup& group, const PolygonMesh& mesh, const PolygonMesh& finer);

Orbits face_orbits(const PolygonMesh& mesh, const SymmetryGroup& group);

}  // namespace umbilic
