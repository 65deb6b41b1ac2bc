// SPDX-License-Identifier: MIT
/// \file
/// What the readers of the single formats hand over to validation; `read.h` is the door for everyone else.
#pragma once

#include <string_view>
#include <vector>

#include "cage/cage.h"

namespace umbilic {

/// Polygons as they stand in a file: finite vertices, and faces that nobody has checked.
struct PolygonFile {
  Cage cage;
  CageSource source;
};

/// `text` begins with an OFF keyword.
bool is_off(std::string_view text);

Result<PolygonFile> parse_obj(std::string_view text);
Result<PolygonFile> parse_off(std::string_view text);

/// Vertices that grow while a file is read.
class VertexList {
 public:
  int size() const { return static_cast<int>(coordinates_.size() / 3); }

  /// Reads x, y and z off the front of `words`; anything behind them is ignored. The error names no line.
  Result<Vector3> append(std::string_view& words);

  Points points() const;

 private:
  std::vector<double> coordinates_;
};

}  // namespace umbilic
