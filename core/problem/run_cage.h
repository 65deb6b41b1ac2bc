// SPDX-License-Identifier: MIT
/// \file
/// The cage of a problem as a run takes it: made, and with the boundaries closed that the problem fills.
///
/// A cage says nothing of how its surface meets a boundary: over the faces that touch it (the group fill-1-rim) the
/// surface depends on what closes it. So these belong to the fill, and unless the problem itself says what is held,
/// everything is held but the groups fill-1 and fill-1-rim, fill-2 and fill-2-rim, …: all vertices of the cage stay
/// (of one that must be refined first, all that the rest depends on), and the surface over the other faces is what it
/// was, to the last bit. `hold` with nothing in it holds nothing.
#pragma once

#include "cage/read.h"
#include "problem/problem.h"

namespace umbilic {

/// The cage that the problem's constraints and fill number: made, and with the faces marked that are holes, but not
/// filled. Where the constraints mark holes, the first vertices of boundaries are numbered from 1, as in the problem.
Result<CheckedCage> cage_with_holes(const Problem& problem);

struct RunCage {
  Cage cage;
  CageReport report;        ///< of this cage; its notes tell what was filled
  Constraints constraints;  ///< the problem's, with elements numbered as in this cage
};

/// Writes into the problem what is held on account of the fill, so that a report tells it. Elements that the problem
/// numbers are those of the cage before it is filled. Errors begin with the cage's name, if it has one.
Result<RunCage> run_cage(Problem& problem);

}  // namespace umbilic
