// SPDX-License-Identifier: MIT
/// \file
/// Looks up groups and faces.
#include "problem/face_selection.h"

#include <fmt/format.h>

#include <algorithm>

#include "cage/text.h"

namespace umbilic {
namespace {

std::string known_groups(const Cage& cage) {
  if (cage.groups.empty()) return "the cage has no groups";
  std::string names;
  for (const FaceGroup& group : cage.groups) names += (names.empty() ? "" : ", ") + in_quotes(group.name);
  return "the cage has " + names;
}

}  // namespace

Result<std::vector<bool>> selected_faces(const Cage& cage, const FaceSelection& selection, std::string_view member) {
  std::vector<bool> result(cage.faces.size(), false);
  for (std::size_t i = 0; i < selection.groups.size(); ++i) {
    const std::string& name = selection.groups[i];
    const auto group =
        std::find_if(cage.groups.begin(), cage.groups.end(), [&](const FaceGroup& g) { return g.name == name; });
    if (group == cage.groups.end()) {
      return Error{fmt::format("constraints.{}.groups[{}]: there is no group {}; {}", member, i, in_quotes(name),
                               known_groups(cage))};
    }
    for (const int f : group->faces) result[f] = true;
  }
  for (std::size_t i = 0; i < selection.faces.size(); ++i) {
    const int number = selection.faces[i];
    if (number < 1 || number > static_cast<int>(cage.faces.size())) {
      return Error{fmt::format("constraints.{}.faces[{}]: there is no face {}; the cage has {}, numbered from 1",
                               member, i, number, cage.faces.size())};
    }
    result[number - 1] = true;
  }
  return result;
}

}  // namespace umbilic
