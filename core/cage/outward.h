// SPDX-License-Identifier: MIT
/// \file
/// Which side of a closed surface is the outside.
#pragma once

#include "cage/cage.h"
#include "cage/edges.h"

namespace umbilic {

/// Makes the faces of each component agree, such that the component encloses positive volume; where its volume vanishes
/// to round-off, such that its first face stays as it is. A face that is turned keeps its first corner.
void turn_outward(Cage& cage, const Orientation& orientation);

}  // namespace umbilic
