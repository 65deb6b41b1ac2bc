// SPDX-License-Identifier: MIT
/// \file
/// What constraints do to a surface: how strongly held parts pull, and how far the surface has moved.
///
/// At a minimum, the gradient of the energy by the control points is balanced by what is held (driver/balance.h). The
/// pull of a pin, of a boundary or of a held region is the derivative of the minimal energy by moving it, while all
/// else that is held stays.
#pragma once

#include <vector>

#include "driver/surface.h"
#include "problem/report.h"

namespace umbilic {

/// The held faces of a mesh, by which of them hang together. Refinement does not change their number or order.
struct HeldRegions {
  std::vector<int> of_face;  ///< the region of each face, or -1 if it is free
  std::vector<int> first_faces, sizes;
  int surface_faces = 0;  ///< held or not

  /// `held` as in RefinedCage.
  HeldRegions(const PolygonMesh& mesh, const std::vector<bool>& held);
  int count() const { return static_cast<int>(sizes.size()); }
};

/// The largest distance, in unit coordinates, between points of the free surface and the same points of the cage's own.
double largest_deviation(const Surface& surface, const Points& control);

/// Of the surface with these control points, whose mesh is refined from the cage of `regions`. The surface must be
/// constrained.
ConstraintsReport constraints_report(const Surface& surface, const Points& control, const HeldRegions& regions);

}  // namespace umbilic
