// SPDX-License-Identifier: MIT
/// \file
/// A JSON text as a tree, as it stands before anything is known of its meaning.
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
  using Object = std::vector<JsonMember>;  ///< in the order of the text, which may repeat a name
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

/// Texts come from strangers: longer and deeper ones are refused.
inline constexpr std::size_t kLongestJson = std::size_t{256} << 20;
inline constexpr int kDeepestJson = 32;

/// Errors name line and column.
Result<JsonNode> parse_json(std::string_view text);

}  // namespace umbilic
