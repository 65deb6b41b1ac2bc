// SPDX-License-Identifier: MIT
/// \file
/// The directions along which no energy can change, whatever the surface: its gauge.
///
/// Functionals see shapes, not where they lie: every one of them is invariant under translations, rotations and, as the
/// area makes those of third order free of scale, changes of size. Those of second order are, up to topology, multiples
/// of Willmore's energy, and invariant under all conformal maps of space: the special conformal directions
/// |x|^2 e - 2 (e . x) x join the similarities.
///
/// Control points that move along a similarity move their surface along it. Along a special conformal direction they do
/// so up to the discretization's error. Whoever looks for a minimum's own directions removes the gauge; a metric that
/// is not invariant keeps its answers free of changes of size, which gain nothing and would add up.
#pragma once

#include "base/types.h"
#include "energy/functional.h"

namespace umbilic {

/// Which families of directions are free. A constraint that holds some of them takes them out.
struct Gauge {
  bool translations = true;
  bool rotations = true;
  bool scaling = true;
  bool conformal = false;  ///< the special conformal maps

  int dimension() const { return 3 * translations + 3 * rotations + scaling + 3 * conformal; }
};

/// Of a weighted functional whose surface is free in space.
constexpr Gauge gauge_of(const Weights& weights) {
  Gauge gauge;
  gauge.conformal = !third_order(weights);
  return gauge;
}

/// A column for each direction, in the order of the members, over the coordinates 3 v + c of the control points v.
/// Taken about the points' centroid, in units of their largest distance from it.
Eigen::MatrixXd gauge_directions(const Gauge& gauge, const Points& control);

/// Orthonormal columns that span the same.
Eigen::MatrixXd orthonormal_gauge(const Gauge& gauge, const Points& control);

/// The direction of growing size about the centroid, x - mean(x): at the same time the gradient of half the points'
/// moment about it.
Points scaling_direction(const Points& control);

}  // namespace umbilic
