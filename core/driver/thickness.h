// SPDX-License-Identifier: MIT
/// \file
/// Makes a thin surface thicker, so that samples see the curvature of its rims.
///
/// A plate, a lens or a needle bends sharply along a rim or at a tip, on a part of its patches as narrow as it is thin:
/// curvature that falls between the samples is missed, Gauss & Bonnet's theorem seems not to hold, and the energies are
/// too low. As an affine map of the control points is one of the surface, each component is stretched about the mean of
/// its points along their principal axes, until their standard deviations along two axes differ by at most a given
/// factor. The isometries of the component commute with that map, so that it keeps its symmetry.
#pragma once

#include <array>

#include "base/types.h"
#include "mesh/components.h"

namespace umbilic {

/// Factors that are tried in this order, until the integral of K is that close to 2 pi chi. A plate 1 : 30 at the level
/// of its cage is 0.04 off; 1 : 333 is 8.1 off, of 4 pi. Closer than kLargestDefect, so that there is room to move.
inline constexpr std::array kThicknessRatios{100.0, 30.0, 10.0, 3.0};
inline constexpr double kThickDefect = 0.05;

/// Components without thickness, whose points lie in one plane to rounding, stay as they are.
Points thickened(const Points& control, const MeshComponents& components, double ratio);

}  // namespace umbilic
