// SPDX-License-Identifier: MIT
/// \file
/// Builds the tree from the events of nlohmann's parser, which works without recursion. Nothing here throws, except for
/// lack of memory. This is the only file of the core that includes that library, which takes seconds to compile.
#include "problem/json_node.h"

#include <fmt/format.h>

#include <algorithm>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

#include "cage/text.h"

namespace umbilic {
namespace {

/// The callbacks of nlohmann::json::sax_parse. Each returns whether to continue.
class TreeBuilder {
 public:
  using Library = nlohmann::json;

  explicit TreeBuilder(std::string_view text) : text_(text) {}

  bool null() { return put(std::monostate()); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(Library::number_integer_t value) { return put(static_cast<double>(value)); }
  bool number_unsigned(Library::number_unsigned_t value) { return put(static_cast<double>(value)); }
  bool number_float(Library::number_float_t value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(Library::binary_t&) { return false; }  // only other formats have it

  bool start_object(std::size_t) { return open(JsonNode::Object()); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(JsonNode::Array()); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    std::get<JsonNode::Object>(open_.back()->value).push_back({std::move(name), {}});
    return true;
  }

  /// `position` counts what the parser has read, up to the end of the last token, which may be long.
  bool parse_error(std::size_t position, const std::string& last, const nlohmann::detail::exception& why) {
    constexpr int kNumberOutOfRange = 406;
    const std::string place = place_of(position);
    if (last.empty()) {
      error_.message = place + ": the text ends too early, it is no JSON";
    } else if (why.id == kNumberOutOfRange) {
      error_.message = fmt::format("{}: the number {} is too large", place, in_quotes(last));
    } else {
      error_.message = fmt::format("{}: this is no JSON, at {}", place, in_quotes(last));
    }
    return false;
  }

  Result<JsonNode> take() {
    if (!error_.message.empty()) return error_;
    return std::move(root_);
  }

 private:
  template <class T>
  bool put(T value) {
    place().value = std::move(value);
    return true;
  }

  template <class T>
  bool open(T container) {
    if (open_.size() >= kDeepestJson) {
      error_.message = fmt::format("nested more than {} deep", kDeepestJson);
      return false;
    }
    JsonNode& node = place();
    node.value = std::move(container);
    open_.push_back(&node);
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  /// Where the next value is stored. Open containers stay at their addresses, because only the innermost one grows.
  JsonNode& place() {
    if (open_.empty()) return root_;
    if (auto* array = std::get_if<JsonNode::Array>(&open_.back()->value)) return array->emplace_back();
    return std::get<JsonNode::Object>(open_.back()->value).back().node;
  }

  /// Of the character before this position.
  std::string place_of(std::size_t position) const {
    const std::string_view before = text_.substr(0, position);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_end = before.rfind('\n');
    return fmt::format("line {}, column {}", line, position - (line_end == before.npos ? 0 : line_end + 1));
  }

  std::string_view text_;
  JsonNode root_;
  std::vector<JsonNode*> open_;
  Error error_;
};

}  // namespace

Result<JsonNode> parse_json(std::string_view text) {
  if (text.size() > kLongestJson) {
    return Error{fmt::format("the text is longer than {} MB", kLongestJson >> 20)};
  }
  TreeBuilder builder(text);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace umbilic
