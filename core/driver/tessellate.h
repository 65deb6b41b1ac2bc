// SPDX-License-Identifier: MIT
/// \file
/// Computes the limit mesh of a layout and its control points.
#pragma once

#include "driver/limit_mesh.h"
#include "mesh/symmetry.h"
#include "surface/layout.h"

namespace umbilic {

/// `layout` must have one patch of each orbit of the group on the faces of `mesh`, and `control` the symmetry of the
/// group. `density` >= 1 is the number of quads along each edge of a patch. Quads are ordered by face and face outward.
LimitMesh tessellate(const PolygonMesh& mesh, const SymmetryGroup& group, const PatchLayout& layout,
                     const Points& control, int density);

}  // namespace umbilic
