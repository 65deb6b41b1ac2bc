// SPDX-License-Identifier: MIT
/// \file
/// From the faces that a problem holds to what holds them on a mesh.
#pragma once

#include <vector>

#include "cage/cage.h"
#include "mesh/polygon_mesh.h"
#include "mesh/symmetry.h"
#include "problem/constraints.h"

namespace umbilic {

/// Of each face of the cage: whether it is held; empty if none is. Errors name a group or face that the cage does not
/// have, and constraints that leave nothing free.
Result<std::vector<bool>> held_faces(const Cage& cage, const Constraints& constraints);

/// The largest subgroup that maps held faces to held faces and, within rounding, the control points that these depend
/// on to one another. Nothing is moved to where a symmetry would have it.
SymmetryGroup symmetry_that_keeps(const std::vector<bool>& held, const SymmetryGroup& group, const PolygonMesh& mesh,
                                  const Points& points);

}  // namespace umbilic
