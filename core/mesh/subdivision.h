// SPDX-License-Identifier: MIT
/// \file
/// The Catmull-Clark step, as a new mesh and the sparse matrix that gives its control points.
#pragma once

#include <Eigen/SparseCore>

#include "mesh/polygon_mesh.h"

namespace umbilic {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct Refinement {
  PolygonMesh mesh;      ///< all quads
  SparseMatrix stencil;  ///< refined vertices x vertices; each row sums to 1
};

/// Refined vertices stand in the order vertices, edges, faces of `mesh`; the quad of a half-edge h is
/// (origin, edge of h, face, edge of previous h), in the order of the half-edges. Catmull & Clark 1978.
Refinement catmull_clark(const PolygonMesh& mesh);
/// The mesh alone.
PolygonMesh catmull_clark_mesh(const PolygonMesh& mesh);

}  // namespace umbilic
