// SPDX-License-Identifier: MIT
/// \file
/// Generated cages with boundaries: the surfaces of revolution and the polygon for which closed forms are known, and
/// saddles over the polygon.
///
/// The cages come with a ring of holes beyond each boundary, which are their last faces, so that every face of the
/// surface has all its neighbours. With the points G beyond the boundary, P on it and Q within, in a row across it,
///
///     C = (G + 4 P + Q) / 6,   D = (Q - G) / 2,   E = G - 2 P + Q
///
/// are the control points of the cubic splines that are the boundary curve, its derivative across (inward, by the width
/// of a quad) and its second derivative. Around a circle of M points they interpolate the exact ones at the M knots,
/// from which they differ by O(M^-4) between: a circle of 32 points by 2.2e-6 of its radius. All other points are such
/// that the limit surface passes through the exact one at its vertices (save those next to the boundary).
#pragma once

#include "base/result.h"
#include "cage/generate.h"

namespace umbilic {

/// The cylinder about the z axis.
Result<Cage> open_cylinder(const CageOptions& options);

/// The catenoid about the z axis: at height z its radius is w cosh(z / w).
Result<Cage> catenoid(const CageOptions& options);

/// The disk about the origin in the plane z = 0: rings of quads around a square grid, whose four corners are the only
/// extraordinary vertices, of valence 3.
Result<Cage> flat_disk(const CageOptions& options);

/// The part of the sphere about the origin within the half-angle of the z axis, with the quads of a disk.
Result<Cage> spherical_cap(const CageOptions& options);

/// The regular polygon of N sides in the plane z = 0 with a corner on the x axis: N grids around its middle. With a
/// rise all its control points are lifted to the harmonic saddle z = rise Re ((x + i y) / radius)^N, which has the
/// height `rise` at the corners (N = 3: the monkey saddle); the symmetry is still that of the polygon, C_Nv.
Result<Cage> n_sided_polygon(const CageOptions& options);

/// The options with the segments of such a cage where they are 0.
CageOptions with_open_defaults(CageKind kind, CageOptions options);

}  // namespace umbilic
