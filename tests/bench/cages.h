// SPDX-License-Identifier: MIT
/// \file
/// The cages that the benchmark minimizes: the generated ones, and some without any symmetry.
#pragma once

#include <string_view>

#include "cage/cage.h"

namespace umbilic {

/// A generated cage, or one without symmetry: "pushed-cube", a cube after two Catmull-Clark steps, 96 faces, pushed out
/// of all symmetry; "animal", an icosahedron after two, 240 quads with 12 vertices of valence 5 and 20 of valence 3, as
/// cages of animals have, pushed too; "moved-NAME", or "moved-NAME:SEED", a generated cage with each coordinate moved
/// by up to 0.12.
Result<Cage> bench_cage(std::string_view name);

}  // namespace umbilic
