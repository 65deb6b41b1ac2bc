// SPDX-License-Identifier: MIT
/// \file
/// How large each component of a cage is, and in how many dimensions.
#pragma once

#include <vector>

#include "cage/cage.h"
#include "cage/edges.h"
#include "cage/placement.h"

namespace umbilic {

/// Volume and area are in the component's unit coordinates, where its longest side is 2 to 4; a face counts as the fan
/// of triangles around its centroid, which favours no corner.
struct ComponentSize {
  int first_face = 0;
  Placement placement;
  /// How far rounding may have moved the points: 1e-12, or more where the component is far from the origin.
  double rounding = 0;
  bool coincident = false;  ///< all vertices in one point
  double width = 0;         ///< largest distance of a vertex from the line through the two that are farthest apart
  double area = 0;
  double volume = 0;  ///< signed, as `Orientation` makes the faces agree; means nothing where there is a boundary

  bool is_line() const { return width <= rounding; }
  bool is_without_area() const { return area <= rounding; }
  bool is_without_volume() const { return (volume < 0 ? -volume : volume) <= rounding * area; }
};

std::vector<ComponentSize> component_sizes(const Cage& cage, const Orientation& orientation);

}  // namespace umbilic
