// SPDX-License-Identifier: MIT
/// \file
/// Writes PLY for tests, by the format's definition and by nothing that the reader uses.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "cage/cage.h"

namespace umbilic::test {

inline const std::vector<std::string> kPlyFormatNames{"ascii", "binary_little_endian", "binary_big_endian"};

/// Appends numbers of any type to a body of one of the formats.
class PlyBody {
 public:
  explicit PlyBody(std::string_view format)
      : ascii_(format == "ascii"),
        reversed_((format == "binary_big_endian") == (std::endian::native == std::endian::little)) {}

  PlyBody& put(std::string_view type, double number) {
    if (ascii_) {
      text_ += type == "float" ? fmt::format("{} ", static_cast<float>(number)) : fmt::format("{} ", number);
    } else if (type == "double") {
      bytes(number);
    } else if (type == "float") {
      bytes(static_cast<float>(number));
    } else if (type == "int" || type == "uint") {
      bytes(static_cast<std::uint32_t>(static_cast<std::int64_t>(number)));
    } else if (type == "short" || type == "ushort") {
      bytes(static_cast<std::uint16_t>(static_cast<std::int64_t>(number)));
    } else {
      bytes(static_cast<std::uint8_t>(static_cast<std::int64_t>(number)));
    }
    return *this;
  }

  /// Ends an element.
  PlyBody& end() {
    if (ascii_) text_ += '\n';
    return *this;
  }

  const std::string& text() const { return text_; }

 private:
  template <class T>
  void bytes(T number) {
    char raw[sizeof(T)];
    std::memcpy(raw, &number, sizeof(T));
    if (reversed_) std::reverse(raw, raw + sizeof(T));
    text_.append(raw, sizeof(T));
  }

  bool ascii_, reversed_;
  std::string text_;
};

struct PlyTypes {
  std::string coordinate = "double";
  std::string length = "uchar";
  std::string index = "int";
};

/// The vertices and faces of a cage, without its groups.
inline std::string write_ply(const Cage& cage, std::string_view format, const PlyTypes& types = {}) {
  std::string header = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n", format, cage.vertices.rows());
  for (const char* axis : {"x", "y", "z"}) header += fmt::format("property {} {}\n", types.coordinate, axis);
  header += fmt::format("element face {}\nproperty list {} {} vertex_indices\nend_header\n", cage.faces.size(),
                        types.length, types.index);
  PlyBody body(format);
  for (Eigen::Index v = 0; v < cage.vertices.rows(); ++v) {
    for (int axis = 0; axis < 3; ++axis) body.put(types.coordinate, cage.vertices(v, axis));
    body.end();
  }
  for (const std::vector<int>& face : cage.faces) {
    body.put(types.length, static_cast<double>(face.size()));
    for (const int v : face) body.put(types.index, v);
    body.end();
  }
  return header + body.text();
}

}  // namespace umbilic::test
