// SPDX-License-Identifier: MIT
/// \file
/// What the parsers of the formats pass to validation. Callers use `read.h`.
#pragma once

#include <string_view>
#include <vector>

#include "cage/cage.h"
#include "cage/read_limits.h"

namespace umbilic {

/// Polygons of a file: finite vertices, and faces that have not been checked.
struct PolygonFile {
  Cage cage;
  CageSource source;
};

/// `text` begins with an OFF keyword.
bool is_off(std::string_view text);

Result<PolygonFile> parse_obj(std::string_view text, const ReadLimits& limits = {});
Result<PolygonFile> parse_off(std::string_view text, const ReadLimits& limits = {});

/// Collects vertices while a file is read.
class VertexList {
 public:
  explicit VertexList(int most) : most_(most) {}

  int size() const { return static_cast<int>(coordinates_.size() / 3); }

  /// Reads x, y and z off the front of `words`; anything behind them is ignored. The error names no line. Fails, too,
  /// where the list is full.
  Result<Vector3> append(std::string_view& words);

  Points points() const;

 private:
  int most_;
  std::vector<double> coordinates_;
};

}  // namespace umbilic
