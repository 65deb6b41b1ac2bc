// SPDX-License-Identifier: MIT
/// \file
/// One Catmull-Clark step of a mesh whose surface is open; see subdivision.h.
#pragma once

#include "mesh/subdivision.h"

namespace umbilic {

/// `catmull_clark` if `mesh.is_open()`.
///
/// Boundaries with ghosts follow the rules of the interior; bare ones those of Catmull-Clark with boundary: cubic
/// B-splines along it, and the corner of a single face stays. Of ghosts' new faces those remain that touch the
/// boundary, which is one ring; bare boundaries get ghosts (mesh/ghosts.h) after the step. So the result has one
/// complete ring of ghosts everywhere, and only vertices that faces use.
///
/// The refined vertices are those of the surface, numbered as if it were alone (its vertices, edges and faces in the
/// order of the mesh), then the ghosts'.
Refinement open_catmull_clark(const PolygonMesh& mesh);
/// Only the mesh.
PolygonMesh open_catmull_clark_mesh(const PolygonMesh& mesh);

}  // namespace umbilic
