// SPDX-License-Identifier: MIT
/// \file
/// Which groups are open, and which faces they have got.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cage/formats.h"
#include "cage/text.h"

namespace umbilic {

Result<int> GroupList::group_called(std::string_view word) {
  if (word.size() > limits_.group_name) {
    return Error{fmt::format("a group's name of more than {} bytes", limits_.group_name)};
  }
  std::string name = printable(word);
  if (const auto known = numbers_.find(name); known != numbers_.end()) return known->second;
  const auto number = static_cast<int>(groups_.size());
  if (number == limits_.groups) return Error{fmt::format("more than {} groups: the file is too large", limits_.groups)};
  groups_.push_back({name, {}});
  numbers_.emplace(std::move(name), number);
  return number;
}

void GroupList::update_current() {
  current_ = named_;
  if (object_) current_.push_back(*object_);
  std::sort(current_.begin(), current_.end());
  current_.erase(std::unique(current_.begin(), current_.end()), current_.end());
}

std::optional<Error> GroupList::begin_groups(std::string_view words) {
  named_.clear();
  for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
    const Result<int> group = group_called(word);
    if (!group) return group.error();
    named_.push_back(*group);
  }
  update_current();
  return std::nullopt;
}

std::optional<Error> GroupList::begin_object(std::string_view words) {
  std::string name;
  for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
    name.append(name.empty() ? "" : "_").append(word);
  }
  object_.reset();
  if (!name.empty()) {
    const Result<int> group = group_called(name);
    if (!group) return group.error();
    object_ = *group;
  }
  update_current();
  return std::nullopt;
}

std::optional<Error> GroupList::append(int face) {
  if (static_cast<int>(current_.size()) > limits_.memberships - memberships_) {
    return Error{fmt::format("more than {} faces in all groups together: the file is too large", limits_.memberships)};
  }
  memberships_ += static_cast<int>(current_.size());
  for (const int group : current_) groups_[group].faces.push_back(face);
  return std::nullopt;
}

std::vector<FaceGroup> GroupList::take() {
  std::vector<FaceGroup> groups;
  for (FaceGroup& group : groups_) {
    if (!group.faces.empty()) groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const FaceGroup& a, const FaceGroup& b) { return a.faces.front() < b.faces.front(); });
  return groups;
}

}  // namespace umbilic
