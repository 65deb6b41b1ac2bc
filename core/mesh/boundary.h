// SPDX-License-Identifier: MIT
/// \file
/// The boundary of an open mesh: its half-edges, its loops, and which of them have ghosts.
#pragma once

#include <vector>

#include "mesh/polygon_mesh.h"

namespace umbilic {

/// The half-edge with which the boundary leaves the vertex, with the surface on its left; -1 if there is none.
/// Counterclockwise from it come the half-edges of the surface's other edges at the vertex.
int boundary_halfedge(const PolygonMesh& mesh, int v);

/// The half-edge of the boundary that follows a half-edge of it.
int next_on_boundary(const PolygonMesh& mesh, int h);

/// Number of the surface's faces at the vertex.
int surface_valence(const PolygonMesh& mesh, int v);

/// Number of fans that the surface's faces form at the vertex; more than one only where holes meet at it.
int surface_fans(const PolygonMesh& mesh, int v);

/// The boundary's loops, each by the half-edges that have the surface on their left, in the order of the least.
std::vector<std::vector<int>> boundary_loops(const PolygonMesh& mesh);

/// Of each vertex, whether it lies on a bare boundary: a loop that touches an outer face, so that some vertex of it
/// lacks ghosts. Empty if no vertex does.
std::vector<bool> bare_vertices(const PolygonMesh& mesh);

}  // namespace umbilic
