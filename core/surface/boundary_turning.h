// SPDX-License-Identifier: MIT
/// \file
/// How much the boundary of a surface turns: the boundary's part of Gauss and Bonnet's theorem,
///   integral of K dA + integral of kappa_g ds + sum of exterior angles = 2 pi chi.
#pragma once

#include "mesh/polygon_mesh.h"
#include "surface/layout.h"

namespace umbilic {

/// The integral of the geodesic curvature along the boundary, with the surface on its left, plus pi minus the interior
/// angle at each boundary vertex; 0 without boundary. Interior angles are sums of the angles of the patches that meet,
/// so that one patch for each orbit suffices. `points` are the layout's (PatchLayout::extend); the layout must cover
/// the whole surface. Flat caps count as bare.
///
/// By `gauss_points` on each edge. Edges that end at an extraordinary vertex are halved towards it.
double boundary_turning(const PolygonMesh& mesh, const PatchLayout& layout, const Points& points, int gauss_points = 8);

}  // namespace umbilic
