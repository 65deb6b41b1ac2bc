// SPDX-License-Identifier: MIT
/// \file
/// Frames: cages of genus (arms − junctions + 1) around a graph on the sphere, in two families.
#pragma once

#include "cage/generate.h"
#include "cage/sphere_map.h"

namespace umbilic {

/// A flag is a triple (junction J, middle M of an arm, tunnel T). The middle surface of a frame is flat on each flag:
/// it lies in the plane through J, M and T', the point above T in the tangent plane of the sphere at M. The sides of
/// the arm are parallel to J M at distance h. On layer d, a point q of the middle surface becomes diag(s + d, s + d, 1
/// + d) q, where s is the spread. Each flag stays within its own cone, and the layers +h and -h are on opposite sides
/// of its plane, so a frame cannot intersect itself.
struct FrameShape {
  double spread = 1;
  double half_width = 0;  ///< h: distance of the control points from the arms' centre lines, 0 < h < min(1, s)
};

/// The shape for the thickness and spread in `options`. Errors name the range that the map allows.
Result<FrameShape> frame_shape(const SphereMap& map, const CageOptions& options);

/// Hub cages: a prism around each junction, with one corner per tunnel, and a square tube of two segments along each
/// arm, with its cross-section inscribed in the circle of radius h. Extraordinary vertices are the corners of the
/// prisms (valence 5) and, after a step, their n-gons.
Cage hub_frame(const SphereMap& map, const FrameShape& shape);

/// Flag cages: two quads for each flag, along the outer and the inner half of the arm, which meet at the crotch and at
/// the arm's side. The cross-section of an arm is a rhombus with half-diagonals h. Extraordinary vertices are the axis
/// points (valence 2n).
Cage flag_frame(const SphereMap& map, const FrameShape& shape);

}  // namespace umbilic
