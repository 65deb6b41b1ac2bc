// SPDX-License-Identifier: MIT
/// \file
/// Orients the faces of each component alike: outward where it is closed.
#pragma once

#include "cage/cage.h"
#include "cage/component_size.h"
#include "cage/edges.h"

namespace umbilic {

struct TurnedFaces {
  int inward = 0;     ///< of components whose faces agreed and enclosed negative volume
  int disagreed = 0;  ///< of other components
};

/// Makes the faces of each component agree, such that a closed component encloses positive volume. Where a component
/// has a boundary it encloses nothing, and where its volume vanishes to rounding, as that of flat cages and of double
/// covers does, no side is the outside: then most of its faces stay as they are, and its first face where neither
/// orientation has most of them. A face that is turned keeps its first corner. Faces that agree are either all turned
/// or none, and a second call turns none.
///
/// `is_open` says of each component whether it has a boundary.
TurnedFaces turn_outward(Cage& cage, const Orientation& orientation, const std::vector<ComponentSize>& sizes,
                         const std::vector<bool>& is_open);

}  // namespace umbilic
