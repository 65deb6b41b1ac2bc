// SPDX-License-Identifier: MIT
/// \file
/// Makes the quads of a pattern and a first guess of the new vertices' positions.
#pragma once

#include <array>
#include <vector>

#include "base/types.h"
#include "cage/fill_pattern.h"

namespace umbilic {

/// Quads within a loop. Vertices 0 … loop − 1 are those of the loop, the others are new.
struct FillQuads {
  int loop = 0;
  std::vector<Vector3> points;
  std::vector<std::array<int, 4>> quads;
};

/// The quads of the pattern within the loop, which lie to its left. The pattern's patch must exist. Grids are Coons
/// patches between their sides, spokes are straight.
FillQuads fill_quads(const std::vector<Vector3>& loop, const FillPattern& pattern);

}  // namespace umbilic
