// SPDX-License-Identifier: MIT
/// \file
/// From the faces that a problem holds to what holds them on a mesh.
#pragma once

#include <vector>

#include "cage/cage.h"
#include "driver/boundary_rows.h"
#include "mesh/polygon_mesh.h"
#include "mesh/symmetry.h"
#include "problem/constraints.h"

namespace umbilic {

/// Of each face of the cage: whether it is held; empty if none is. Errors name a group or face that the cage does not
/// have, and constraints that leave nothing free.
Result<std::vector<bool>> held_faces(const Cage& cage, const Constraints& constraints);

/// The faces of a mesh to which the symmetries map those that are `selected`.
std::vector<bool> images_of_faces(const std::vector<bool>& selected, const std::vector<Symmetry>& symmetries,
                                  const PolygonMesh& mesh);

/// Which symmetries keep held faces and boundaries.
class HeldFaces {
 public:
  /// `held` and `boundary` as in RefinedCage; `points` are the cage's. All must outlive this.
  HeldFaces(const std::vector<bool>& held, const std::vector<BoundaryCondition>& boundary, const PolygonMesh& mesh,
            const Points& points);

  /// Whether the symmetry, about `center`, maps held faces to held faces, boundaries to boundaries with the same
  /// condition and, within rounding, the control points that these depend on to one another. Nothing is moved to where
  /// a symmetry would have it.
  bool kept_by(const Symmetry& symmetry, const Vector3& center) const;

 private:
  const std::vector<bool>& held_;
  const std::vector<BoundaryCondition>& boundary_;
  const PolygonMesh& mesh_;
  const Points& points_;
  std::vector<bool> near_;  // of each vertex: whether it is near a held face or a held boundary
  double largest_difference_ = 0;
};

}  // namespace umbilic
