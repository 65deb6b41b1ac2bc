// SPDX-License-Identifier: MIT
/// \file
/// Writes polygon meshes as OBJ text.
#include "cage/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace umbilic {

namespace {

void append_row(std::string& out, const char* keyword, const Points& rows, Eigen::Index i) {
  fmt::format_to(std::back_inserter(out), "{} {} {} {}\n", keyword, rows(i, 0), rows(i, 1), rows(i, 2));
}

/// Collects lines and hands them on in pieces.
class Pieces {
 public:
  explicit Pieces(const TextSink& take) : take_(take) {}

  /// The lines that have not been handed on; lines are appended here.
  std::string& lines() { return lines_; }

  /// To be called after each line. False if the sink takes no more.
  bool pass() { return lines_.size() < kPieceBytes || finish(); }

  /// Hands on what is left.
  bool finish() {
    const bool taken = take_(lines_);
    lines_.clear();
    return taken;
  }

 private:
  static constexpr std::size_t kPieceBytes = 1 << 16;
  const TextSink& take_;
  std::string lines_;
};

bool write_rows(Pieces& out, const char* keyword, const Points& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    append_row(out.lines(), keyword, rows, i);
    if (!out.pass()) return false;
  }
  return true;
}

/// Goes through the faces in their order, and tells where the groups of a face are others than those of the face
/// before.
class GroupChanges {
 public:
  explicit GroupChanges(const Cage& cage)
      : groups_(groups_and_holes(cage)), groups_of_face_(groups_.empty() ? 0 : cage.faces.size()) {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      for (const int face : groups_[g].faces) groups_of_face_[face].push_back(static_cast<int>(g));
    }
  }

  /// The statement that the face needs before it, if any.
  std::string before(std::size_t face) const {
    static const std::vector<int> none;
    if (groups_of_face_.empty()) return "";
    const std::vector<int>& last = face > 0 ? groups_of_face_[face - 1] : none;
    if (groups_of_face_[face] == last) return "";
    std::string statement = "g";
    for (const int group : groups_of_face_[face]) statement.append(" ").append(groups_[group].name);
    // A backslash at the end would join the next line.
    return statement.append(statement.back() == '\\' ? " \n" : "\n");
  }

 private:
  /// The cage's groups, and its holes unless they are one of these. A name that another group has would join the two.
  static std::vector<FaceGroup> groups_and_holes(const Cage& cage) {
    std::vector<FaceGroup> groups = cage.groups;
    const auto has = [&](const auto& condition) { return std::any_of(groups.begin(), groups.end(), condition); };
    if (cage.holes.empty() || has([&](const FaceGroup& group) { return group.faces == cage.holes; })) return groups;
    std::string name(kHoleGroup);
    while (has([&](const FaceGroup& group) { return group.name == name; })) name += '_';
    groups.push_back({std::move(name), cage.holes});
    return groups;
  }

  std::vector<FaceGroup> groups_;
  std::vector<std::vector<int>> groups_of_face_;  // empty if there are no groups
};

}  // namespace

std::string write_obj(const Cage& cage) {
  std::string out;
  for (Eigen::Index i = 0; i < cage.vertices.rows(); ++i) append_row(out, "v", cage.vertices, i);
  const GroupChanges groups(cage);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    out += groups.before(f);
    out += 'f';
    for (const int vertex : cage.faces[f]) out += fmt::format(" {}", vertex + 1);
    out += '\n';
  }
  return out;
}

bool write_obj(const Points& positions, const Points& normals, const std::vector<std::array<int, 4>>& quads,
               const TextSink& take) {
  assert(positions.rows() == normals.rows());
  Pieces out(take);
  if (!write_rows(out, "v", positions) || !write_rows(out, "vn", normals)) return false;
  for (const std::array<int, 4>& quad : quads) {
    out.lines() += 'f';
    for (const int vertex : quad) fmt::format_to(std::back_inserter(out.lines()), " {0}//{0}", vertex + 1);
    out.lines() += '\n';
    if (!out.pass()) return false;
  }
  return out.finish();
}

std::string write_obj(const Points& positions, const Points& normals, const std::vector<std::array<int, 4>>& quads) {
  std::string text;
  write_obj(positions, normals, quads, [&](std::string_view piece) {
    text.append(piece);
    return true;
  });
  return text;
}

}  // namespace umbilic
