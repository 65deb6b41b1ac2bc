// SPDX-License-Identifier: MIT
/// \file
/// One Catmull-Clark step: the refined mesh, and the sparse matrix that gives its control points.
#pragma once

#include <Eigen/SparseCore>

#include "mesh/polygon_mesh.h"

namespace umbilic {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct Refinement {
  PolygonMesh mesh;      ///< all quads, but for the outer faces of an open surface
  SparseMatrix stencil;  ///< refined vertices x vertices; each row sums to 1
};

/// The refined vertices are those of the vertices, then edges, then faces of `mesh`. Quads are in the order of the
/// half-edges; that of h is (origin(h), edge of h, face of h, edge of previous(h)). Catmull & Clark 1978.
///
/// If the surface is open, that holds for the surface alone, and ghosts follow; see mesh/open_subdivision.h.
Refinement catmull_clark(const PolygonMesh& mesh);
/// Only the mesh.
PolygonMesh catmull_clark_mesh(const PolygonMesh& mesh);

}  // namespace umbilic
