// SPDX-License-Identifier: MIT
/// \file
/// Which boundaries of the cage are closed with quads before the run; see cage/fill.h.
#pragma once

#include <type_traits>
#include <vector>

namespace umbilic {

/// Boundaries are numbered from 1 as `umbilic info` lists them, vertices as in the file.
///
///     {}                                     // all boundaries
///     {"loops": [2], "corners": [1, 4, 13, 16]}    // the second, by a grid between these vertices
struct FillRequest {
  std::vector<int> loops{};    ///< all if empty
  std::vector<int> corners{};  ///< of any of these loops

  template <class Visit, class Self>
  static void members(Visit&& visit, Self& self) {
    constexpr bool reads = !std::is_const_v<Self>;
    if (reads || !self.loops.empty()) visit("loops", self.loops, "Numbers of boundaries, from 1; all unless given");
    if (reads || !self.corners.empty()) {
      visit("corners", self.corners,
            "Vertices of these boundaries that are to be corners of their patches of quads, 3 to 12 of a boundary; "
            "chosen where the cage turns, unless given");
    }
  }
};

}  // namespace umbilic
