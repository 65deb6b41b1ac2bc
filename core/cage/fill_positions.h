// SPDX-License-Identifier: MIT
/// \file
/// Where the new vertices of a fill lie.
#pragma once

#include <vector>

#include "cage/fill_quads.h"

namespace umbilic {

/// Moves the new vertices to where the sum of |mean of the neighbours − u|² over the new vertices u and of
/// |p − v − h t|² over the loop's vertices v is least, where p is the new neighbour of v (or, at a corner, the opposite
/// vertex of its quad), t the unit vector `directions[v]`, in which the surface arrives at v (or 0), and h the distance
/// from v to p as it was.
void smooth_fill(FillQuads& fill, const std::vector<Vector3>& directions);

}  // namespace umbilic
