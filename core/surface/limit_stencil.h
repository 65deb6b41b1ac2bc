// SPDX-License-Identifier: MIT
/// \file
/// Points of the limit surface as linear functions of the control points: position and two tangents.
///
/// The surface is S, the limit of the Catmull-Clark steps, without caps. A place on it means the same on every
/// refinement of a mesh:
///
///     SurfacePlace place{.halfedge = h, .u = 0.25, .v = 0.5};  // in a quad of the cage
///     place = refined(place, cage);                             // in a quad of catmull_clark_mesh(cage)
///     LimitStencil stencil = limit_stencil(mesh, place);
#pragma once

#include <vector>

#include "mesh/subdivision.h"

namespace umbilic {

/// A vertex, or a point of a quad: (0, 0) at the origin of a half-edge, u along it and v along the one before it,
/// backwards; (1, 1) at the opposite corner. In a face that is no quad: the same in the quad that the first step makes
/// around the origin of the half-edge, (1, 1) in the middle of the face.
struct SurfacePlace {
  int vertex = -1;  ///< -1: a point of a face
  int halfedge = -1;
  double u = 0, v = 0;
  int steps = 0;  ///< since the quad by whose coordinates tangents are derivatives

  bool is_vertex() const { return vertex >= 0; }
  bool operator==(const SurfacePlace&) const = default;
};

/// The same place on catmull_clark_mesh(mesh).
SurfacePlace refined(const SurfacePlace& place, const PolygonMesh& mesh);

/// With P the control points, the sums over i of weights(k, i) P(points[i]) are the position (k = 0) and two tangents
/// (k = 1, 2) whose cross product points outward. In a quad these are the derivatives by u and v of the quad from which
/// the place's steps are counted; at a vertex, and at an extraordinary corner of a quad, they span the tangent plane,
/// and their lengths mean nothing.
struct LimitStencil {
  std::vector<int> points;  ///< rising
  Eigen::Matrix<double, 3, Eigen::Dynamic> weights;

  /// The position and the tangents, a column each.
  Eigen::Matrix3d apply(const Points& control) const;
};

/// The stencils over the points of `mesh`, whose faces may have any size and its quads any number of extraordinary
/// vertices: it is refined as often as needed, at most twice. Valences of vertices and faces must be at least 3.
std::vector<LimitStencil> limit_stencils(const PolygonMesh& mesh, const std::vector<SurfacePlace>& places);

}  // namespace umbilic
