// SPDX-License-Identifier: MIT
/// \file
/// Writes polygon meshes as OBJ text.
#include "cage/write.h"

#include <fmt/format.h>

#include <cassert>

namespace umbilic {

namespace {

void append_rows(std::string& out, const char* keyword, const Points& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    out += fmt::format("{} {} {} {}\n", keyword, rows(i, 0), rows(i, 1), rows(i, 2));
  }
}

/// Goes through the faces in their order, and tells where the groups of a face are others than those of the face
/// before.
class GroupChanges {
 public:
  explicit GroupChanges(const Cage& cage) : cage_(cage), groups_of_face_(cage.groups.empty() ? 0 : cage.faces.size()) {
    for (std::size_t g = 0; g < cage.groups.size(); ++g) {
      for (const int face : cage.groups[g].faces) groups_of_face_[face].push_back(static_cast<int>(g));
    }
  }

  /// The statement that the face needs before it, if any.
  std::string before(std::size_t face) const {
    static const std::vector<int> none;
    if (groups_of_face_.empty()) return "";
    const std::vector<int>& last = face > 0 ? groups_of_face_[face - 1] : none;
    if (groups_of_face_[face] == last) return "";
    std::string statement = "g";
    for (const int group : groups_of_face_[face]) statement.append(" ").append(cage_.groups[group].name);
    // A backslash at the end would join the next line.
    return statement.append(statement.back() == '\\' ? " \n" : "\n");
  }

 private:
  const Cage& cage_;
  std::vector<std::vector<int>> groups_of_face_;  // empty if there are no groups
};

}  // namespace

std::string write_obj(const Cage& cage) {
  std::string out;
  append_rows(out, "v", cage.vertices);
  const GroupChanges groups(cage);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    out += groups.before(f);
    out += 'f';
    for (const int vertex : cage.faces[f]) out += fmt::format(" {}", vertex + 1);
    out += '\n';
  }
  return out;
}

std::string write_obj(const Points& positions, const Points& normals, const std::vector<std::array<int, 4>>& quads) {
  assert(positions.rows() == normals.rows());
  std::string out;
  append_rows(out, "v", positions);
  append_rows(out, "vn", normals);
  for (const std::array<int, 4>& quad : quads) {
    out += 'f';
    for (const int vertex : quad) out += fmt::format(" {0}//{0}", vertex + 1);
    out += '\n';
  }
  return out;
}

}  // namespace umbilic
