// SPDX-License-Identifier: MIT
/// \file
/// Reads structs that list their members from a JSON tree. Only the first error is kept; it names the member:
/// "options.levels[1]: expected a whole number".
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/types.h"
#include "energy/functional.h"
#include "problem/json_node.h"
#include "problem/members.h"

namespace umbilic {

class JsonReader;

/// Visits the members of a struct and reads each from an object.
class ObjectReader {
 public:
  ObjectReader(JsonReader& reader, const JsonNode::Object& object) : reader_(reader), object_(object) {}

  template <class T>
  void operator()(std::string_view name, T& member, std::string_view = {});
  template <class T>
  void required(std::string_view name, T& member, std::string_view = {});
  template <class T>
  void pair(std::string_view name, T& first, T& second, std::string_view = {});

  /// Reports an error for a member that was not visited.
  void refuse_the_rest();

 private:
  /// The member with this name, or null. Two members with the same name are an error.
  const JsonNode* find(std::string_view name);

  JsonReader& reader_;
  const JsonNode::Object& object_;
  std::vector<std::string_view> known_;
};

class JsonReader {
 public:
  bool ok() const { return !error_; }
  const Error& error() const { return *error_; }

  /// Keeps the error for the current position, unless there is one already.
  void fail(std::string_view words);

  void read(const JsonNode& node, bool& value);
  void read(const JsonNode& node, int& value);
  /// null becomes NaN.
  void read(const JsonNode& node, double& value);
  void read(const JsonNode& node, std::string& value);
  void read(const JsonNode& node, Points& points);
  void read(const JsonNode& node, Weights& weights);

  template <NamedEnumeration E>
  void read(const JsonNode& node, E& value) {
    const std::vector<std::string_view> names = names_of<E>();
    const int index = read_name(node, names);
    if (index >= 0) value = static_cast<E>(index);
  }

  template <class T>
  void read(const JsonNode& node, std::optional<T>& value) {
    read(node, value.emplace());
  }

  template <class T>
  void read(const JsonNode& node, std::vector<T>& values) {
    const auto* array = node.get_if<JsonNode::Array>();
    if (!array) return fail("expected an array");
    values.resize(array->size());
    for (std::size_t i = 0; i < values.size() && ok(); ++i) read_element((*array)[i], i, values[i]);
  }

  template <class T, std::size_t count>
  void read(const JsonNode& node, std::array<T, count>& values) {
    const auto* array = node.get_if<JsonNode::Array>();
    if (!array || array->size() != count) return fail("expected an array of " + std::to_string(count));
    for (std::size_t i = 0; i < count && ok(); ++i) read_element((*array)[i], i, values[i]);
  }

  /// true or false, or else what the other alternative reads.
  template <class T>
  void read(const JsonNode& node, std::variant<bool, T>& value) {
    if (const bool* flag = node.get_if<bool>()) {
      value = *flag;
    } else {
      read(node, value.template emplace<T>());
    }
  }

  template <class T>
  void read_pair(const JsonNode& node, T& first, T& second) {
    const auto* array = node.get_if<JsonNode::Array>();
    if (!array || array->size() != 2) return fail("expected two numbers, [first, second]");
    read_element((*array)[0], 0, first);
    read_element((*array)[1], 1, second);
  }

  /// Reads the alternative whose key member is present.
  template <class... Alternatives>
  void read(const JsonNode& node, std::variant<Alternatives...>& value) {
    const auto* object = node.get_if<JsonNode::Object>();
    if (!object) return fail("expected an object");
    const int index = alternative(*object, {Alternatives::kKey...});
    int i = 0;
    (void)((i++ == index && (read(node, value.template emplace<Alternatives>()), true)) || ...);
  }

  template <HasMembers T>
  void read(const JsonNode& node, T& value) {
    const auto* object = node.get_if<JsonNode::Object>();
    if (!object) return fail("expected an object");
    ObjectReader members(*this, *object);
    read_members(members, value);
  }

  /// Reads the members of a struct from an object that may also have others.
  template <HasMembers T>
  void read_members(ObjectReader& members, T& value) {
    const Unknown outside = unknown_;
    if constexpr (requires { T::kUnknown; }) unknown_ = T::kUnknown;
    T::members(members, value);
    if (unknown_ == Unknown::kRefused) members.refuse_the_rest();
    unknown_ = outside;
    if constexpr (requires(Error & error) { in_range(value, error); }) {
      if (Error error; ok() && !in_range(value, error)) fail_below(error.message);
    }
  }

 private:
  friend class ObjectReader;

  /// Appends a member's name to the path during its lifetime.
  class Inside {
   public:
    Inside(JsonReader& reader, std::string_view name) : path_(reader.path_), length_(path_.size()) {
      if (!path_.empty()) path_ += '.';
      path_ += name;
    }
    Inside(JsonReader& reader, std::size_t index) : path_(reader.path_), length_(path_.size()) {
      path_ += '[' + std::to_string(index) + ']';
    }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() { path_.resize(length_); }

   private:
    std::string& path_;
    std::size_t length_;
  };

  template <class T>
  void read_element(const JsonNode& node, std::size_t index, T& value) {
    const Inside inside(*this, index);
    read(node, value);
  }

  /// Index of a word in the list; -1, with an error, if it is not in the list.
  int read_name(const JsonNode& node, const std::vector<std::string_view>& names);
  /// Index of the only one of these keys that the object has; -1, with an error, otherwise.
  int alternative(const JsonNode::Object& object, const std::vector<std::string_view>& keys);
  /// Reports an error for a member of the current value, with whose name the text begins.
  void fail_below(std::string_view words);

  Unknown unknown_ = Unknown::kRefused;
  std::string path_;
  std::optional<Error> error_;
};

template <class T>
void ObjectReader::operator()(std::string_view name, T& member, std::string_view) {
  const JsonReader::Inside inside(reader_, name);
  if (const JsonNode* node = find(name); node && reader_.ok()) reader_.read(*node, member);
}

template <class T>
void ObjectReader::required(std::string_view name, T& member, std::string_view) {
  const JsonReader::Inside inside(reader_, name);
  const JsonNode* node = find(name);
  if (!node) return reader_.fail("missing");
  if (reader_.ok()) reader_.read(*node, member);
}

template <class T>
void ObjectReader::pair(std::string_view name, T& first, T& second, std::string_view) {
  const JsonReader::Inside inside(reader_, name);
  if (const JsonNode* node = find(name); node && reader_.ok()) reader_.read_pair(*node, first, second);
}

}  // namespace umbilic
