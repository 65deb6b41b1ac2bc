// SPDX-License-Identifier: MIT
/// \file
/// Polygon meshes as OBJ text, with the shortest decimals that are read back as the same doubles.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// The group that has a cage's holes, for which OBJ has no word. With underscores behind it where another has this
/// name.
inline constexpr std::string_view kHoleGroup = "hole";

/// With the cage's groups, and its holes as the group kHoleGroup. What is written reads back to the same cage, whose
/// holes are again faces until it is said that they are holes.
std::string write_obj(const Cage& cage);

/// Takes the next piece of a text; false if it could not, and then gets no more.
using TextSink = std::function<bool(std::string_view)>;

/// Quads with one normal per vertex, in pieces of some 64 KB, since the whole text may take more memory than the mesh.
/// Returns whether `take` took all of it.
bool write_obj(const Points& positions, const Points& normals, const std::vector<std::array<int, 4>>& quads,
               const TextSink& take);

/// The same as one text.
std::string write_obj(const Points& positions, const Points& normals, const std::vector<std::array<int, 4>>& quads);

}  // namespace umbilic
