// SPDX-License-Identifier: MIT
/// \file
/// A JSON text as a tree, before its meaning is known.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"

namespace umbilic {

struct JsonMember;

struct JsonNode {
  using Array = std::vector<JsonNode>;
  using Object = std::vector<JsonMember>;  ///< in the order of the text; names may occur twice
  std::variant<std::monostate, bool, double, std::string, Array, Object> value;

  template <class T>
  const T* get_if() const {
    return std::get_if<T>(&value);
  }
};

struct JsonMember {
  std::string name;
  JsonNode node;
};

/// Limits for untrusted texts: longer and deeper ones are refused.
inline constexpr std::size_t kLongestJson = std::size_t{256} << 20;
inline constexpr int kDeepestJson = 32;

/// Errors name the line and column.
Result<JsonNode> parse_json(std::string_view text);

}  // namespace umbilic
