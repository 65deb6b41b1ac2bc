// SPDX-License-Identifier: MIT
/// \file
/// The unit normal that a flat cap projects along, as a function of the control points, and its pullback.
#pragma once

#include <vector>

#include "surface/layout.h"

namespace umbilic {

struct FlatFrame {
  Vector3 tangents[2];
  Vector3 normal;  ///< unit
  double length;   ///< length of the cross product of the limit tangents
};

/// The frame from the limit tangents at the cap's extraordinary vertex.
FlatFrame flat_frame(const Cap& cap, const Points& points);

/// Adds the gradient of normal . normal_adjoint (with normal_adjoint constant) to `gradient`.
void pull_back_frame(const Cap& cap, const FlatFrame& frame, const Vector3& normal_adjoint, Points& gradient);

/// The frames of all caps of a layout; empty unless the caps are flat.
std::vector<FlatFrame> flat_frames(const PatchLayout& layout, const Points& points);
void flat_frames(const PatchLayout& layout, const Points& points, std::vector<FlatFrame>& frames);

}  // namespace umbilic
