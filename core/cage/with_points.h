// SPDX-License-Identifier: MIT
/// \file
/// A cage whose points have moved, with the same faces.
#pragma once

#include "cage/cage.h"

namespace umbilic {

/// The validated `cage` with other points, as many x 3. Fails where there are not as many, where the cage with them is
/// not valid (validate), and where its closed components would be inside out, so that validating turned faces. Errors
/// begin with "points: ".
Result<Cage> with_points(Cage cage, const Points& points);

}  // namespace umbilic
