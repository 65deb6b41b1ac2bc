// SPDX-License-Identifier: MIT
/// \file
/// Polygon meshes as OBJ text, with the shortest decimals that are read back as the same doubles.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// With the cage's groups. What is written reads back to the same cage.
std::string write_obj(const Cage& cage);

/// Quads with one normal per vertex.
std::string write_obj(const Points& positions, const Points& normals, const std::vector<std::array<int, 4>>& quads);

}  // namespace umbilic
