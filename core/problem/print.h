// SPDX-License-Identifier: MIT
/// \file
/// Prints structs that list their members as JSON. Numbers have the fewest digits that are read back as the same
/// number; those that are not finite become null. An empty optional member is omitted.
#pragma once

#include <array>
#include <string>

#include "base/types.h"
#include "energy/functional.h"
#include "problem/members.h"

namespace umbilic {

class JsonPrinter {
 public:
  enum class Layout { kCompact, kIndented };

  explicit JsonPrinter(Layout layout) : layout_(layout) {}

  /// Prints one member of the current object.
  template <class T>
  void operator()(std::string_view name, const T& member, std::string_view = {}) {
    begin_member(name);
    print(member);
  }
  template <class T>
  void operator()(std::string_view name, const std::optional<T>& member, std::string_view = {}) {
    if (member) (*this)(name, *member);
  }
  template <class T>
  void required(std::string_view name, const T& member, std::string_view = {}) {
    (*this)(name, member);
  }
  template <class T>
  void pair(std::string_view name, const T& first, const T& second, std::string_view = {}) {
    begin_member(name);
    text_ += '[';
    print(first);
    text_ += layout_ == Layout::kIndented ? ", " : ",";
    print(second);
    text_ += ']';
  }

  void print(bool value);
  void print(int value);
  void print(double value);
  void print(std::string_view value);
  void print(const std::string& value) { print(std::string_view(value)); }
  void print(const char* value) { print(std::string_view(value)); }
  /// x, y, z, x, y, z, …
  void print(const Points& points);
  /// Prints the nonzero weights by name.
  void print(const Weights& weights);
  template <NamedEnumeration E>
  void print(E value) {
    print(name_of(value));
  }
  template <class T>
  void print(const std::map<int, T>& values) {
    open('{');
    for (const auto& [key, value] : values) (*this)(std::to_string(key), value);
    close('}');
  }
  template <class T>
  void print(const std::vector<T>& values) {
    open('[');
    for (const T& value : values) {
      begin_element();
      print(value);
    }
    close(']');
  }
  /// On one line, as few values are.
  template <class T, std::size_t count>
  void print(const std::array<T, count>& values) {
    text_ += '[';
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) text_ += layout_ == Layout::kIndented ? ", " : ",";
      print(values[i]);
    }
    text_ += ']';
  }
  template <class... Alternatives>
  void print(const std::variant<Alternatives...>& value) {
    std::visit([&](const auto& alternative) { print(alternative); }, value);
  }
  template <HasMembers T>
  void print(const T& value) {
    open('{');
    T::members(*this, value);
    close('}');
  }

  // For values without a struct: begin_member("a"), open('['), begin_element(), print(1), close(']').
  void open(char bracket);
  void close(char bracket);
  void begin_member(std::string_view name);
  void begin_element();

  std::string take() { return std::move(text_); }

 private:
  void new_line();

  Layout layout_;
  std::string text_;
  int depth_ = 0;
  bool empty_ = true;  // whether the innermost bracket is still empty
};

/// Prints without line breaks.
template <class T>
std::string json_text(const T& value) {
  JsonPrinter printer(JsonPrinter::Layout::kCompact);
  printer.print(value);
  return printer.take();
}

}  // namespace umbilic
