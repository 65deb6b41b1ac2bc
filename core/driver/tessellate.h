// SPDX-License-Identifier: MIT
/// \file
/// From a layout and its control points to a limit mesh.
#pragma once

#include "driver/limit_mesh.h"
#include "surface/layout.h"

namespace umbilic {

/// `layout` belongs to `mesh`; `density` >= 1 quads along each edge of a patch.
LimitMesh tessellate(const PolygonMesh& mesh, const PatchLayout& layout, const Points& control, int density);

}  // namespace umbilic
