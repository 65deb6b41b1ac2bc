// SPDX-License-Identifier: MIT
/// \file
/// The forces that hold a surface at rest where something is held.
///
/// Let E be what is minimized, A P = b the equations of pins and boundaries, and H the control points that held faces
/// depend on. At a minimum the gradient is balanced,
///
///     dE/dP = A^T lambda + r,   r = 0 but at H.
///
/// lambda is the derivative of the minimal energy by b, and r that by the held points, while everything else that is
/// held stays. Where equations follow from others, some of these are dropped, and have no part in lambda: what is held
/// together then moves together.
#pragma once

#include <vector>

#include "driver/pin_rows.h"
#include "driver/surface.h"

namespace umbilic {

/// In unit coordinates.
struct Balance {
  PinRows rows;
  Eigen::VectorXd multipliers;  ///< lambda; 0 for equations that follow from others
  std::vector<int> redundant;   ///< the equations that follow from others
  Points reactions;             ///< r, with the rounding and what is left of the gradient elsewhere
};

/// Of the surface with these control points. Where it is not at a minimum, lambda is such that A^T lambda is nearest to
/// the gradient at the points that are not held.
Balance balance_of(const Surface& surface, const Points& control);

/// What moving all that is held of a loop of the boundary does to the minimal energy, in unit coordinates. It turns
/// about `center`, the mean of its vertices' limit points, and the derivatives across the boundary that are held turn
/// with it.
struct LoopPull {
  int loop;                          ///< zero-based, as constraints number boundaries
  Vector3 center = Vector3::Zero();  ///< of the cage's own surface
  Vector3 force = Vector3::Zero();   ///< its derivative by moving the loop
  Vector3 moment = Vector3::Zero();  ///< by turning the loop: about an axis a of length 1 it is a . moment
  double total = 0;                  ///< the lengths of the forces at the loop's vertices, summed
};

/// Of each loop that has equations, in their order.
std::vector<LoopPull> loop_pulls(const Balance& balance, const RefinedCage& cage);

}  // namespace umbilic
