// SPDX-License-Identifier: MIT
/// \file
/// From a layout and its control points to a limit mesh.
#pragma once

#include "driver/limit_mesh.h"
#include "mesh/symmetry.h"
#include "surface/layout.h"

namespace umbilic {

/// `layout` has one patch of each orbit of the group on the faces of `mesh`, and `control` its symmetry; `density` >= 1
/// quads along each edge of a patch. Quads stand face by face, outward.
LimitMesh tessellate(const PolygonMesh& mesh, const SymmetryGroup& group, const PatchLayout& layout,
                     const Points& control, int density);

}  // namespace umbilic
