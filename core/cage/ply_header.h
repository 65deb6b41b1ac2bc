// SPDX-License-Identifier: MIT
/// \file
/// How a PLY file begins: what elements follow, of which numbers they consist, and how these are written.
///
///     ply
///     format ascii 1.0                        # or binary_little_endian, binary_big_endian
///     comment …                               # and obj_info …: anywhere, not read
///     element vertex 8                        # as often as there are kinds of elements
///     property double x                       # a number of each element of this kind, in their order
///     element face 6
///     property list uchar int vertex_indices  # how many numbers, and the numbers
///     end_header
///
/// After Turk, The PLY polygon file format (1994); types also with the names that say their bits, as int32.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace umbilic {

enum class PlyFormat { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct PlyProperty {
  std::string_view name;
  PlyType type{};                        ///< of the number, or of those of the list
  std::optional<PlyType> length_type{};  ///< of the number that says how long a list is; none if it is no list
};

struct PlyElement {
  std::string_view name;
  long long count = 0;
  int line = 0;
  std::vector<PlyProperty> properties{};
};

struct PlyHeader {
  PlyFormat format{};
  std::vector<PlyElement> elements{};  ///< in the order in which they follow
  std::string_view body{};             ///< the file behind the header
  int lines = 0;                       ///< of the header

  /// The element of this name, or null.
  const PlyElement* find(std::string_view name) const;
};

/// The views are into `file`. Errors name the line.
Result<PlyHeader> parse_ply_header(std::string_view file);

}  // namespace umbilic
