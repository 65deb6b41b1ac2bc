// SPDX-License-Identifier: MIT
/// \file
/// Where a cage lies and how large it is, taken off it before anything is computed and put back on what comes out.
#pragma once

#include "base/types.h"

namespace umbilic {

/// The map x = 2^exponent u + centre between a cage's own coordinates x and unit coordinates u, in which the longest
/// side of the cage's box is at least 2 and less than 4, as that of the generated cages, and the cage lies about the
/// origin.
///
/// - The scale is a power of two: a cage scaled by a power of two has the same unit coordinates, to the last bit.
/// - A cage whose unit coordinates are all below 8, so that it lies within about three times its longest side of the
///   origin, is not moved; its points are as exact where they are.
/// - Any other is moved by the middle of its box, rounded to a multiple of 2^exponent / 2. That subtraction is exact,
/// as
///   the difference of two numbers with few digits behind the point: what rounding there is, is the input's own.
///
/// Surfaces, symmetries and energies are computed in unit coordinates. Of what is reported, lengths go back by
/// 2^exponent, areas by 4^exponent, curvatures by 2^-exponent; the energies do not depend on size.
struct Placement {
  Vector3 centre = Vector3::Zero();
  int exponent = 0;

  /// Whether the cage lies about the origin where it is.
  bool is_centred() const { return centre.isZero(0); }

  Points to_unit(const Points& points) const;
  Points back(const Points& points) const;
  /// The same for one point.
  Vector3 to_unit(const Vector3& point) const;
  Vector3 back(const Vector3& point) const;

  /// Half a unit in the last place of each coordinate, in unit coordinates: how far the point may be from the one that
  /// was meant.
  Points rounding(const Points& points) const;
};

/// The placement of finite points, by their bounding box; the identity where they coincide.
Placement placement_of(const Points& points);
/// The same from the least and greatest coordinates.
Placement placement_of(const Vector3& low, const Vector3& high);

}  // namespace umbilic
