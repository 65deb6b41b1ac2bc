// SPDX-License-Identifier: MIT
/// \file
/// Frames: cages of genus (arms − junctions + 1) around a graph on the sphere, in two families.
#pragma once

#include "cage/generate.h"
#include "cage/sphere_map.h"

namespace umbilic {

/// The middle surface of a frame is flat on each flag (junction J, arm's middle M, tunnel T): the plane through J, M
/// and the point T' above T that lies in the tangent plane of the sphere at M. The arm's sides run parallel to J M, in
/// the distance h. A point q of the middle surface becomes diag(s + d, s + d, 1 + d) q on the layer d; s is the spread.
/// Each flag keeps to its own cone, with the layers +h and −h on opposite sides of its plane, so a frame cannot
/// intersect itself.
struct FrameShape {
  double spread = 1;
  double half_width = 0;  ///< h: distance of the control points from the arms' centre lines, 0 < h < min(1, s)
};

/// The shape for the thickness and spread in `options`; errors name the range that the map leaves room for.
Result<FrameShape> frame_shape(const SphereMap& map, const CageOptions& options);

/// Hub cages: around each junction a prism with one corner per tunnel, along each arm a square tube of two segments,
/// its cross-section inscribed in the circle of radius h. Extraordinary vertices: the prisms' corners (valence 5) and,
/// after a step, their n-gons.
Cage hub_frame(const SphereMap& map, const FrameShape& shape);

/// Flag cages: two quads for each flag (junction, arm, side), along the arm's outer and inner half, meeting in the
/// crotch and in the arm's side. The arms' cross-section is a rhombus of half-diagonals h. Extraordinary vertices: the
/// axis points (valence 2n).
Cage flag_frame(const SphereMap& map, const FrameShape& shape);

}  // namespace umbilic
