// SPDX-License-Identifier: MIT
/// \file
/// How a struct lists its members, once, for all code that iterates over them: the printer, the reader and the schema
/// of the text form. A struct with members `level` and `energy` has
///
///     template <class Visit, class Self>
///     static void members(Visit&& visit, Self& self) {
///       visit("level", self.level, "Catmull-Clark steps from the cage");
///       visit("energy", self.energy, "By the reporting rule");
///     }
///
/// `Self` is const if the members are only read. The text describes the member in the schema, and may be omitted if
/// there is no schema. A member that is missing in the text keeps its value, unless it is visited by
/// `visit.required(name, member, words)`. `visit.pair(name, first, second, words)` visits two numbers that form one
/// member [first, second]. A new member of a struct is printed, read and documented as soon as it is in the list.
#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace umbilic {

/// Enumerations are words in the text form: `name_of(E)` is the word of each enumerator, numbered from 0 without a gap,
/// and empty for all other values.
template <class E>
concept NamedEnumeration = std::is_enum_v<E> && requires(E e) {
  { name_of(e) } -> std::convertible_to<std::string_view>;
};

template <NamedEnumeration E>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for (int i = 0; !name_of(static_cast<E>(i)).empty(); ++i) names.push_back(name_of(static_cast<E>(i)));
  return names;
}

/// How the reader treats members that a struct does not have. A struct chooses by its constant `kUnknown`, which also
/// holds for all that it contains. In a problem they are refused, since ignoring one would solve another problem; in a
/// report they are ignored, since a newer program may report more.
enum class Unknown { kRefused, kIgnored };

namespace detail {
struct AnyVisit {
  template <class T>
  void operator()(std::string_view, T&, std::string_view = {}) {}
  template <class T>
  void required(std::string_view, T&, std::string_view = {}) {}
  template <class T>
  void pair(std::string_view, T&, T&, std::string_view = {}) {}
};
}  // namespace detail

/// A struct that lists its members.
template <class T>
concept HasMembers = requires(T& value, detail::AnyVisit visit) {
  std::remove_cvref_t<T>::members(visit, value);
};

}  // namespace umbilic
