// SPDX-License-Identifier: MIT
/// \file
/// What core/opinion finds of a surface, beside what the report says.
#pragma once

#include "driver/surface.h"
#include "problem/energy_report.h"

namespace umbilic {

/// Of the surface of `cage`, which must be evaluable, with its own points; `energies` are those of the main evaluation.
/// Takes some microseconds for each of several hundred points of each face.
OpinionReport second_opinion(const RefinedCage& cage, CapChoice cap, const EnergyReport& energies,
                             OpinionFaces faces = OpinionFaces::kAll);

/// The cage after `steps` further Catmull-Clark steps, whose points, where the cage is closed, another implementation
/// of the step has found.
RefinedCage refine_otherwise(RefinedCage cage, int steps);

}  // namespace umbilic
