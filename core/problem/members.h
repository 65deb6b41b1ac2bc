// SPDX-License-Identifier: MIT
/// \file
/// How a struct says what it consists of, once, for everything that goes over its members: the printer, the reader and
/// the schema of the text form. A struct with members `level` and `energy` has
///
///     template <class Visit, class Self>
///     static void members(Visit&& visit, Self& self) {
///       visit("level", self.level, "Catmull-Clark steps from the cage");
///       visit("energy", self.energy, "By the reporting rule");
///     }
///
/// `Self` is const where the members are only looked at. The words describe the member in the schema. A member that is
/// not there when it is read keeps its value, unless it is visited by `visit.required(name, member, words)`;
/// `visit.pair(name, first, second, words)` visits two numbers that stand together as [first, second]. A new member of
/// a struct thereby is printed, read and documented as soon as it is in the list. The words may be left out where there
/// is no schema.
#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace umbilic {

/// Enumerations in a text form are words: `name_of(E)` is a word for each enumerator, from 0 on without a gap, and
/// empty for everything else.
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

/// What becomes of members that a struct does not have when it is read. A struct says so by its constant `kUnknown`,
/// for all that it contains as well: to overlook what was asked would answer another question, but a newer program may
/// have more to say in an answer.
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

/// A struct with a list of its members.
template <class T>
concept HasMembers = requires(T& value, detail::AnyVisit visit) {
  std::remove_cvref_t<T>::members(visit, value);
};

}  // namespace umbilic
