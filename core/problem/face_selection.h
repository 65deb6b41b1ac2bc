// SPDX-License-Identifier: MIT
/// \file
/// The faces of a cage that a problem selects.
#pragma once

#include <string_view>
#include <vector>

#include "cage/cage.h"
#include "problem/constraints.h"

namespace umbilic {

/// Of each face: whether it is selected. Errors name a group or face that the cage does not have; `member` is the
/// member of the constraints that selects.
Result<std::vector<bool>> selected_faces(const Cage& cage, const FaceSelection& selection, std::string_view member);

}  // namespace umbilic
