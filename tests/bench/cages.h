// SPDX-License-Identifier: MIT
/// \file
/// The cages that the benchmark minimizes: the generated ones, and one without any symmetry.
#pragma once

#include <string_view>

#include "cage/cage.h"

namespace umbilic {

/// A generated cage, or one without symmetry: "pushed-cube", a cube after two Catmull-Clark steps, 96 faces, pushed out
/// of all symmetry; "moved-two-3", the genus-2 flag frame with each coordinate moved by up to 0.12.
Result<Cage> bench_cage(std::string_view name);

}  // namespace umbilic
