// SPDX-License-Identifier: MIT
/// \file
/// A point of the surface that is held, and where.
#pragma once

#include "base/types.h"
#include "surface/limit_stencil.h"

namespace umbilic {

/// A pin with its place and its targets, in unit coordinates.
struct HeldPoint {
  int pin = 0;   ///< zero-based number in the problem
  int copy = 0;  ///< 0 for the pin itself, from 1 for its images under the cage's symmetry
  SurfacePlace place{};
  Vector3 position = Vector3::Zero();
  bool holds[3] = {};                ///< which coordinates of the position
  Vector3 normal = Vector3::Zero();  ///< of length 1, pointing outward; zero if it is not held

  bool holds_normal() const { return !normal.isZero(0); }
  bool holds_position() const { return holds[0] || holds[1] || holds[2]; }
};

}  // namespace umbilic
