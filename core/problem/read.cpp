// SPDX-License-Identifier: MIT
/// \file
/// Reads values without members, and words the errors.
#include "problem/read.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cage/text.h"

namespace umbilic {

void JsonReader::fail(std::string_view words) {
  if (!error_) error_ = Error{path_.empty() ? std::string(words) : fmt::format("{}: {}", path_, words)};
}

void JsonReader::fail_below(std::string_view words) {
  if (!error_) error_ = Error{path_.empty() ? std::string(words) : fmt::format("{}.{}", path_, words)};
}

void JsonReader::read(const JsonNode& node, bool& value) {
  const bool* found = node.get_if<bool>();
  if (!found) return fail("expected true or false");
  value = *found;
}

void JsonReader::read(const JsonNode& node, int& value) {
  const double* found = node.get_if<double>();
  if (!found || *found != std::floor(*found)) return fail("expected a whole number");
  if (std::abs(*found) > std::numeric_limits<int>::max()) return fail(fmt::format("{} is too large", *found));
  value = static_cast<int>(*found);
}

void JsonReader::read(const JsonNode& node, double& value) {
  if (node.get_if<std::monostate>()) {
    value = std::numeric_limits<double>::quiet_NaN();
  } else if (const double* found = node.get_if<double>()) {
    value = *found;
  } else {
    fail("expected a number");
  }
}

void JsonReader::read(const JsonNode& node, std::string& value) {
  const std::string* found = node.get_if<std::string>();
  if (!found) return fail("expected a string");
  value = *found;
}

void JsonReader::read(const JsonNode& node, Points& points) {
  const auto* numbers = node.get_if<JsonNode::Array>();
  if (!numbers) return fail("expected an array of numbers");
  if (numbers->size() % 3 != 0) return fail(fmt::format("{} numbers, not three for each point", numbers->size()));
  points.resize(static_cast<Eigen::Index>(numbers->size() / 3), 3);
  for (std::size_t i = 0; i < numbers->size() && ok(); ++i) read_element((*numbers)[i], i, points.data()[i]);
}

void JsonReader::read(const JsonNode& node, Weights& weights) {
  const auto* object = node.get_if<JsonNode::Object>();
  if (!object) return fail("expected an object");
  weights = {};
  ObjectReader members(*this, *object);
  for (int i = 0; i < kFunctionalCount; ++i) members(kFunctionalNames[i], weights[i]);
  for (const auto& [name, value] : *object) {
    if (std::find(kFunctionalNames.begin(), kFunctionalNames.end(), name) != kFunctionalNames.end()) continue;
    const Inside inside(*this, in_quotes(name));
    fail(fmt::format("no functional; known are {}", fmt::join(kFunctionalNames, ", ")));
  }
  if (Error error; ok() && !usable(weights, error)) fail(error.message);
}

int JsonReader::read_name(const JsonNode& node, const std::vector<std::string_view>& names) {
  const std::string* found = node.get_if<std::string>();
  const auto name = found ? std::find(names.begin(), names.end(), *found) : names.end();
  if (name != names.end()) return static_cast<int>(name - names.begin());
  fail(fmt::format("{}expected one of {}", found ? in_quotes(*found) + " is unknown, " : "", fmt::join(names, ", ")));
  return -1;
}

int JsonReader::alternative(const JsonNode::Object& object, const std::vector<std::string_view>& keys) {
  std::vector<int> present;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool there = std::any_of(object.begin(), object.end(), [&](const auto& m) { return m.name == keys[i]; });
    if (there) present.push_back(static_cast<int>(i));
  }
  if (present.size() == 1) return present[0];
  fail(fmt::format("expected one of the members {}", fmt::join(keys, ", ")));
  return -1;
}

const JsonNode* ObjectReader::find(std::string_view name) {
  known_.push_back(name);
  const auto named = [&](const JsonMember& member) { return member.name == name; };
  const auto first = std::find_if(object_.begin(), object_.end(), named);
  if (first == object_.end()) return nullptr;
  if (std::find_if(first + 1, object_.end(), named) != object_.end()) reader_.fail("stands there twice");
  return &first->node;
}

void ObjectReader::refuse_the_rest() {
  for (const JsonMember& member : object_) {
    if (std::find(known_.begin(), known_.end(), member.name) != known_.end()) continue;
    const JsonReader::Inside inside(reader_, in_quotes(member.name));
    return reader_.fail(fmt::format("unknown; known are {}", fmt::join(known_, ", ")));
  }
}

}  // namespace umbilic
