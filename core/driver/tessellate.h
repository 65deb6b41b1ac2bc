// SPDX-License-Identifier: MIT
/// \file
/// Computes the limit mesh of a layout and its control points.
#pragma once

#include <optional>

#include "driver/limit_mesh.h"
#include "energy/functional.h"
#include "mesh/symmetry.h"
#include "surface/layout.h"

namespace umbilic {

/// The integrand of the minimized energy: sum over functionals f of weights[f] area_factor^area_power(f) times the
/// density of f (energy/densities.h). Its integral over the surface is the energy, which has no unit, so it is in
/// 1/length^2 for all functionals. The area that is their factor counts as a constant.
struct EnergyDensity {
  Weights weights;
  double area_factor;  ///< the surface's area, or what replaces it; > 0
};

/// `layout` must have one patch of each orbit of the group on the faces of `mesh`, and `control` the symmetry of the
/// group. `density` >= 1 is the number of quads along each edge of a patch. Quads are ordered by face and face outward.
/// With `energy` the mesh has densities. Those of third order jump from patch to patch; a vertex has the mean over its
/// patches.
LimitMesh tessellate(const PolygonMesh& mesh, const SymmetryGroup& group, const PatchLayout& layout,
                     const Points& control, int density, const std::optional<EnergyDensity>& energy = {});

}  // namespace umbilic
