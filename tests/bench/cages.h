// SPDX-License-Identifier: MIT
/// \file
/// The cages that the benchmark minimizes: the generated ones, and one without any symmetry.
#pragma once

#include <string_view>

#include "cage/cage.h"

namespace umbilic {

/// A generated cage, or "pushed-cube": a cube after two Catmull-Clark steps, 96 faces, pushed out of all symmetry.
Result<Cage> bench_cage(std::string_view name);

}  // namespace umbilic
