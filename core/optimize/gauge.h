// SPDX-License-Identifier: MIT
/// \file
/// The gauge: the directions in which no energy changes, whatever the surface.
///
/// Energies depend on shape only. All of them are invariant under translations, rotations and scaling (the factor area
/// makes those of third order independent of scale). Those of second order are, up to topology, multiples of Willmore's
/// energy, which all conformal maps of space preserve: their gauge also has the special conformal directions |x|^2 e -
/// 2 (e . x) x.
///
/// Moving the control points along a similarity moves the surface along it exactly; along a special conformal direction
/// only up to the discretization error.
///
/// Two users: the test for a minimum removes the gauge, in which the Hessian is zero; and a metric that is not
/// invariant under scaling keeps its directions free of it, since changes of size gain nothing and would add up.
#pragma once

#include "base/types.h"
#include "energy/functional.h"

namespace umbilic {

/// The families of directions in the gauge. A constraint that fixes some of them removes them from it.
struct Gauge {
  bool translations = true;
  bool rotations = true;
  bool scaling = true;
  bool conformal = false;  ///< the special conformal maps

  int dimension() const { return 3 * translations + 3 * rotations + scaling + 3 * conformal; }
};

/// The gauge of a weighted functional without constraints.
constexpr Gauge gauge_of(const Weights& weights) {
  Gauge gauge;
  gauge.conformal = !third_order(weights);
  return gauge;
}

/// One column per direction, in the order of the members, over the coordinates 3 v + c of the control points v.
/// Positions are relative to the centroid and divided by the largest distance from it.
Eigen::MatrixXd gauge_directions(const Gauge& gauge, const Points& control);

/// An orthonormal basis of the span of `gauge_directions`.
Eigen::MatrixXd orthonormal_gauge(const Gauge& gauge, const Points& control);

/// Replaces independent columns by an orthonormal basis of their span.
void orthonormalize(Eigen::MatrixXd& columns);

/// The direction of growth about the centroid, x - mean(x). It is also the gradient of half the points' moment about
/// their centroid.
Points scaling_direction(const Points& control);

}  // namespace umbilic
