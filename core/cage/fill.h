// SPDX-License-Identifier: MIT
/// \file
/// Closes boundary loops of an open cage with quads.
///
/// A loop of even length is filled by a patch of s sides that meet at s corners on the loop: s grids of quads around
/// one new vertex, or a single grid where s = 4. The only extraordinary vertices are that middle vertex, of valence s,
/// and those corners where the cage does not turn. In a patch with n edges on each half of a side, every ring of quads
/// is 2s edges shorter than the one around it, until a fan of s quads is left.
///
/// - Where 3 to 12 of the loop's vertices have three or more faces and divide the loop into sides that such a patch can
///   have, these are the corners. They end with one more face, and the others with two more: a hole from which the
///   faces around a vertex were taken gets them back, and an N-sided hole its vertex of valence N.
/// - Elsewhere the loop is smooth, and a ring of quads as long as the loop comes first, so that the loop's vertices
///   become regular. The patch within has four corners where the loop's length is a multiple of 4, else five or three
///   if that divides it evenly, else four with sides that differ by one edge; they lie where the loop turns most.
///
/// A loop of odd length cannot be filled with quads: then one Catmull-Clark step of the whole cage comes first. It
/// also comes where the patch would have no vertex inside, as over a single quad that was taken out of a grid: then
/// there would be nothing to shape. Whoever wants just that quad marks its corners.
///
/// The new vertices lie so that the squares of the differences of each from the mean of its neighbours, and of the turn
/// of the quads across the loop, are least in sum: the fill goes on in the direction in which the surface arrives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cage/cage.h"

namespace umbilic {

/// Vertices of a loop that are to be the corners of its patch: 3 to 12, in any order.
struct FillCorners {
  int loop = 0;
  std::vector<int> vertices;
};

struct FillOptions {
  std::vector<int> loops{};            ///< zero-based, of `surface_boundaries`; all if empty
  std::vector<FillCorners> corners{};  ///< at most one for each loop; without, they are chosen as above
};

/// `rim` are the faces that touch the loop, or the quads of those that touched it before the cage was refined: what
/// closes the loop decides on their surface, and all other faces keep theirs. The step's rules for boundaries move the
/// loop off the surface, so that it should not be held; only where that would leave no other face, the rim of a refined
/// cage is the quads that touch the loop.
struct FilledLoop {
  int loop = 0;
  int edges = 0;              ///< of the loop when it was filled
  std::vector<int> faces;     ///< new faces
  std::vector<int> vertices;  ///< new vertices
  std::vector<int> rim;
  std::string group;      ///< name of the group of the new faces: fill-1, or the next that was not taken
  std::string rim_group;  ///< the same with -rim
};

struct FilledCage {
  Cage cage;  ///< the faces and vertices that were there (or came of those by `refined`) come first, in their order
  std::vector<FilledLoop> loops;
  /// If one Catmull-Clark step of the whole cage came first (see refine.h), why; else empty.
  std::optional<std::string> refined;
  std::vector<int> vertex_numbers;  ///< of each vertex that was there: its number in `cage`, or -1
  std::vector<int> face_numbers;    ///< of each face that was there: the number of it or of its first quad, or -1
};

/// The longest loop that is filled; its 2701 vertices take a second or two.
inline constexpr int kLongestFilledLoop = 200;

/// `cage` must have passed `validate`. Faces marked as holes that touch a filled loop, directly or by others, are taken
/// out, and so are vertices that no other face uses. What is not filled keeps its groups. Errors name the loop as a
/// boundary, and number boundaries and vertices from 1.
Result<FilledCage> fill(const Cage& cage, const FillOptions& options = {});

}  // namespace umbilic
