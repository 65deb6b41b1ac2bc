// SPDX-License-Identifier: MIT
/// \file
/// What the parsers of the formats pass to validation. Callers use `read.h`.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cage/cage.h"
#include "cage/read_limits.h"

namespace umbilic {

/// Polygons of a file: finite vertices, and faces that have not been checked.
struct PolygonFile {
  Cage cage;
  CageSource source;
  std::vector<std::string> notes;  ///< what was ignored of the file that its user may have meant
};

/// `text` begins with an OFF keyword.
bool is_off(std::string_view text);

/// `file` begins with the line "ply".
bool is_ply(std::string_view file);

Result<PolygonFile> parse_obj(std::string_view text, const ReadLimits& limits = {});
Result<PolygonFile> parse_off(std::string_view text, const ReadLimits& limits = {});
/// Of the formats ascii, whose errors name lines, and binary, whose errors name elements: "face 3: …".
Result<PolygonFile> parse_ply(std::string_view file, const ReadLimits& limits = {});

inline Error at_line(int line, const std::string& message) {
  return Error{"line " + std::to_string(line) + ": " + message};
}

/// Elements of one kind that have what is not read.
struct Ignored {
  int count = 0;
  int first_line = 0;

  void add(int line) {
    if (count++ == 0) first_line = line;
  }
  /// "on line 7", or "the first on line 7".
  std::string where() const { return (count == 1 ? "on line " : "the first on line ") + std::to_string(first_line); }
};

/// Collects vertices while a file is read.
class VertexList {
 public:
  explicit VertexList(int most) : most_(most) {}

  int size() const { return static_cast<int>(coordinates_.size() / 3); }

  /// Reads x, y and z off the front of `words`; anything behind them is ignored. The error names no line. Fails, too,
  /// where the list is full.
  Result<Vector3> append(std::string_view& words);

  /// Adds a finite position to a list that is not full.
  void add(const Vector3& position);

  Points points() const;

 private:
  int most_;
  std::vector<double> coordinates_;
};

/// Collects groups of faces while an OBJ file is read. A face belongs to all groups that the last `g` names, and to the
/// object that the last `o` names, which is a group as well. Errors name no line.
class GroupList {
 public:
  explicit GroupList(const ReadLimits& limits) : limits_(limits) {}

  /// The words after `g`; without any the groups end, but not the object.
  std::optional<Error> begin_groups(std::string_view words);
  /// The words after `o`, which are one name: blanks inside become underscores. Without any the object ends.
  std::optional<Error> begin_object(std::string_view words);

  /// The next face, which is the one of this index.
  std::optional<Error> append(int face);

  /// Those that have faces, in the order of their first faces.
  std::vector<FaceGroup> take();

 private:
  Result<int> group_called(std::string_view word);
  void update_current();

  ReadLimits limits_;
  std::map<std::string, int> numbers_;
  std::vector<FaceGroup> groups_;  // in the order of their names in the text
  std::vector<int> named_;         // by the last g
  std::optional<int> object_;
  std::vector<int> current_;  // both, each group once
  int memberships_ = 0;
};

/// Counts the lines that begin with `t`, by which programs write creases into OBJ files. They would change the surface,
/// so that a user should know that they are ignored.
class TagCounts {
 public:
  /// The words after `t`.
  void append(std::string_view words, int line);

  /// A sentence for each kind.
  std::vector<std::string> notes() const;

 private:
  struct Kind {
    int lines = 0;
    int first_line = 0;
  };
  std::array<Kind, 4> kinds_{};
};

}  // namespace umbilic
