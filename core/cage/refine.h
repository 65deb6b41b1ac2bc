// SPDX-License-Identifier: MIT
/// \file
/// One Catmull-Clark step of a cage that may be open.
#pragma once

#include "cage/cage.h"

namespace umbilic {

/// The cage after one step of Catmull & Clark with the usual rules at a boundary: its edges have their middles, a
/// vertex between boundary neighbours a and b moves to (a + 6 v + b) / 8, and the only corner of one face stays. The
/// vertices are those of the vertices, edges and faces of `cage`. Each corner of a face, in their order, becomes the
/// quad (vertex, edge that follows, face, edge before), a hole and in the groups in which the face is. Every boundary
/// loop becomes twice as long, and its former vertices keep their numbers.
///
/// Each edge must have one or two faces and each vertex one fan of them.
Cage refined(const Cage& cage);

}  // namespace umbilic
