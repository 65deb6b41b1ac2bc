// SPDX-License-Identifier: MIT
/// \file
/// Chooses the loops, refines the cage if one of them needs it, and adds the quads of each.
#include "cage/fill.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>
#include <set>

#include "cage/boundary.h"
#include "cage/edges.h"
#include "cage/fill_pattern.h"
#include "cage/fill_positions.h"
#include "cage/fill_quads.h"
#include "cage/refine.h"

namespace umbilic {

namespace {

using Loop = std::vector<int>;

/// A loop to fill: its number, its vertices with the fill to the left, its marked corners, and the faces whose surface
/// depends on the fill.
struct Task {
  int number = 0;
  Loop loop;
  std::vector<int> corners;
  std::vector<int> rim;

  Error error(const std::string& what) const { return Error{fmt::format("boundary {} {}", number + 1, what)}; }
};

/// Turns the loop, which keeps its first vertex, so that what is missing lies to its left.
void turn(Loop& loop) { std::reverse(loop.begin() + 1, loop.end()); }

Result<std::vector<int>> chosen_loops(const FillOptions& options, int count) {
  if (count == 0) return Error{"the cage is closed, and has no boundary to fill"};
  std::vector<int> loops = options.loops;
  if (loops.empty()) {
    loops.resize(count);
    std::iota(loops.begin(), loops.end(), 0);
  }
  std::set<int> met;
  for (const int loop : loops) {
    if (loop < 0 || loop >= count) {
      return Error{fmt::format("there is no boundary {}; the cage has {}", loop + 1, count)};
    }
    if (!met.insert(loop).second) return Error{fmt::format("boundary {} is to be filled twice", loop + 1)};
  }
  return loops;
}

/// Adds the marked corners to the tasks.
std::optional<Error> mark_corners(const FillOptions& options, std::vector<Task>& tasks) {
  for (const FillCorners& marked : options.corners) {
    const auto task = std::find_if(tasks.begin(), tasks.end(), [&](const Task& t) { return t.number == marked.loop; });
    if (task == tasks.end()) {
      return Error{fmt::format("boundary {} has marked corners, but is not filled", marked.loop + 1)};
    }
    if (!task->corners.empty()) return task->error("has marked corners twice");
    task->corners = marked.vertices;
    std::set<int> met;
    for (const int v : marked.vertices) {
      if (std::find(task->loop.begin(), task->loop.end(), v) == task->loop.end()) {
        return task->error(fmt::format("does not pass vertex {}, which is marked as its corner", v + 1));
      }
      if (!met.insert(v).second) return task->error(fmt::format("has vertex {} as a corner twice", v + 1));
    }
    if (met.size() < 3 || met.size() > 12) return task->error(fmt::format("has {} corners, not 3 to 12", met.size()));
  }
  return std::nullopt;
}

/// The positions of the marked corners on the loop, rising.
std::vector<int> corner_positions(const Task& task) {
  std::vector<int> positions;
  for (std::size_t i = 0; i < task.loop.size(); ++i) {
    if (std::find(task.corners.begin(), task.corners.end(), task.loop[i]) != task.corners.end()) {
      positions.push_back(static_cast<int>(i));
    }
  }
  return positions;
}

/// Takes out the faces marked as holes that touch the loops, directly or by others, and the vertices that only they
/// have. Numbers what was there.
void open_holes(FilledCage& filled, std::vector<Task>& tasks) {
  Cage& cage = filled.cage;
  filled.vertex_numbers.resize(cage.vertices.rows());
  filled.face_numbers.resize(cage.faces.size());
  std::iota(filled.vertex_numbers.begin(), filled.vertex_numbers.end(), 0);
  std::iota(filled.face_numbers.begin(), filled.face_numbers.end(), 0);
  if (cage.holes.empty()) return;
  std::vector<bool> touched(cage.vertices.rows(), false), removed(cage.faces.size(), false);
  for (const Task& task : tasks) {
    for (const int v : task.loop) touched[v] = true;
  }
  for (bool more = true; more;) {
    more = false;
    for (const int f : cage.holes) {
      const std::vector<int>& face = cage.faces[f];
      if (removed[f] || std::none_of(face.begin(), face.end(), [&](int v) { return touched[v]; })) continue;
      more = removed[f] = true;
      for (const int v : face) touched[v] = true;
    }
  }

  Cage kept;
  std::vector<int>&renumbered = filled.vertex_numbers, &new_face = filled.face_numbers;
  std::fill(renumbered.begin(), renumbered.end(), -1);
  std::fill(new_face.begin(), new_face.end(), -1);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    if (removed[f]) continue;
    new_face[f] = static_cast<int>(kept.faces.size());
    kept.faces.push_back(cage.faces[f]);
    for (const int v : cage.faces[f]) renumbered[v] = 0;
  }
  const auto kept_of = [&](const std::vector<int>& faces) {
    std::vector<int> numbers;
    for (const int f : faces) {
      if (!removed[f]) numbers.push_back(new_face[f]);
    }
    return numbers;
  };
  kept.holes = kept_of(cage.holes);
  for (const FaceGroup& group : cage.groups) {
    FaceGroup rest{group.name, kept_of(group.faces)};
    if (!rest.faces.empty()) kept.groups.push_back(std::move(rest));
  }
  int count = 0;
  kept.vertices.resize(cage.vertices.rows(), 3);
  for (int v = 0; v < cage.vertices.rows(); ++v) {
    if (renumbered[v] < 0) continue;
    kept.vertices.row(count) = cage.vertices.row(v);
    renumbered[v] = count++;
  }
  kept.vertices.conservativeResize(count, Eigen::NoChange);
  for (std::vector<int>& face : kept.faces) {
    for (int& v : face) v = renumbered[v];
  }
  for (Task& task : tasks) {
    for (int& v : task.loop) v = renumbered[v];
    for (int& v : task.corners) v = renumbered[v];
  }
  cage = std::move(kept);
}

/// What the cage is like at the vertices of its boundary: the faces around each, and the direction in which the surface
/// arrives: that of the edges from within or, at the only corner of a face, that from the face's middle.
struct Arrival {
  std::vector<int> faces;
  std::vector<Vector3> directions;  ///< unit vectors, or 0

  explicit Arrival(const Cage& cage) : faces(cage.vertices.rows(), 0) {
    const auto point = [&](int v) { return Vector3(cage.vertices.row(v)); };
    directions.assign(cage.vertices.rows(), Vector3::Zero());
    const std::vector<EdgeUse> uses = edge_uses(cage);
    for (std::size_t i = 1; i < uses.size(); ++i) {
      if (!same_edge(uses[i - 1], uses[i])) continue;
      const Vector3 edge = point(uses[i].high) - point(uses[i].low);
      directions[uses[i].high] += edge;
      directions[uses[i].low] -= edge;
    }
    for (const std::vector<int>& face : cage.faces) {
      for (const int v : face) ++faces[v];
    }
    for (const std::vector<int>& face : cage.faces) {
      Vector3 middle = Vector3::Zero();
      for (const int v : face) middle += point(v) / static_cast<double>(face.size());
      for (const int v : face) {
        if (faces[v] == 1) directions[v] = point(v) - middle;
      }
    }
    for (Vector3& direction : directions) {
      if (const double length = direction.norm(); length > 0) direction /= length;
    }
  }
};

template <class T>
std::vector<T> along(const Loop& loop, const std::vector<T>& of_vertices) {
  std::vector<T> values;
  for (const int v : loop) values.push_back(of_vertices[v]);
  return values;
}

std::vector<Vector3> points_of(const Cage& cage, const Loop& loop) {
  std::vector<Vector3> points;
  for (const int v : loop) points.push_back(cage.vertices.row(v));
  return points;
}

/// Of each face that was there the first of the quads that it becomes.
void number_quads(FilledCage& filled) {
  std::vector<int> first{0};
  for (const std::vector<int>& face : filled.cage.faces) first.push_back(first.back() + static_cast<int>(face.size()));
  for (int& number : filled.face_numbers) {
    if (number >= 0) number = first[number];
  }
}

/// The loop after a step of the cage, in which its vertices have kept their numbers.
Loop refined_loop(const Loop& loop, const Cage& refined_cage) {
  for (Loop& candidate : surface_boundaries(refined_cage)) {
    if (std::find(candidate.begin(), candidate.end(), loop[0]) == candidate.end()) continue;
    turn(candidate);
    return candidate;
  }
  assert(false);
  return {};
}

std::optional<FillPattern> pattern_of(const Task& task, const Cage& cage, const Arrival& arrival) {
  if (task.corners.empty()) return fill_pattern(points_of(cage, task.loop), along(task.loop, arrival.faces));
  if (task.loop.size() % 2 != 0) return std::nullopt;
  return FillPattern{false, corner_positions(task)};
}

/// Why the cage must be refined for the loop, which has no pattern.
std::string why_refined(const Task& task) {
  if (task.loop.size() % 2 != 0) {
    return fmt::format("boundary {} has {} vertices, and quads close only an even number", task.number + 1,
                       task.loop.size());
  }
  return fmt::format("the quads within boundary {} would have no vertex inside to be shaped", task.number + 1);
}

/// Why the marked corners do not bound a patch.
std::optional<Error> check_sides(const Task& task, const FillPattern& pattern) {
  const std::vector<int> sides = sides_between(pattern.corners, static_cast<int>(task.loop.size()));
  if (is_patch(sides)) return std::nullopt;
  const std::string numbers = fmt::format("{}", fmt::join(sides, ", "));
  if (sides.size() == 4) {
    return task.error(
        fmt::format("has sides of {} edges between its corners, but opposite ones must have equally many", numbers));
  }
  return task.error(fmt::format("has sides of {} edges between its corners, which no patch of quads has", numbers));
}

/// The first name fill-N from this number on that no group has, nor fill-N-rim.
std::string free_name(const Cage& cage, int number) {
  for (;; ++number) {
    std::string name = fmt::format("fill-{}", number), rim = name + "-rim";
    const auto called = [&](const FaceGroup& group) { return group.name == name || group.name == rim; };
    if (std::none_of(cage.groups.begin(), cage.groups.end(), called)) return name;
  }
}

/// The faces that touch the loop.
std::vector<int> faces_around(const Loop& loop, const Cage& cage) {
  const std::set<int> vertices(loop.begin(), loop.end());
  std::vector<int> faces;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int>& face = cage.faces[f];
    if (std::any_of(face.begin(), face.end(), [&](int v) { return vertices.count(v) > 0; })) {
      faces.push_back(static_cast<int>(f));
    }
  }
  return faces;
}

/// Whether some face of the surface is in no rim.
bool leave_a_rest(const std::vector<Task>& tasks, const Cage& cage) {
  std::set<int> faces(cage.holes.begin(), cage.holes.end());
  for (const Task& task : tasks) faces.insert(task.rim.begin(), task.rim.end());
  return faces.size() < cage.faces.size();
}

/// The quads that the faces become in a step.
std::vector<int> children_of(const std::vector<int>& faces, const Cage& cage) {
  std::vector<int> first{0}, quads;
  for (const std::vector<int>& face : cage.faces) first.push_back(first.back() + static_cast<int>(face.size()));
  for (const int f : faces) {
    for (int quad = first[f]; quad < first[f + 1]; ++quad) quads.push_back(quad);
  }
  return quads;
}

/// Keeps the order of the groups, that of their first faces.
void add_group(Cage& cage, FaceGroup group) {
  const auto later = [&](const FaceGroup& other) { return other.faces.front() > group.faces.front(); };
  cage.groups.insert(std::find_if(cage.groups.begin(), cage.groups.end(), later), std::move(group));
}

/// Adds the quads; the new vertices are smoothed.
Result<FilledLoop> add(const Task& task, const FillPattern& pattern, const Arrival& arrival, Cage& cage) {
  if (auto error = check_sides(task, pattern)) return *error;
  FillQuads quads = fill_quads(points_of(cage, task.loop), pattern);
  smooth_fill(quads, along(task.loop, arrival.directions));

  FilledLoop filled{task.number, static_cast<int>(task.loop.size()), {}, {}, task.rim, "", ""};
  filled.group = free_name(cage, task.number + 1);
  filled.rim_group = filled.group + "-rim";
  std::vector<int> number = task.loop;
  const auto before = static_cast<int>(cage.vertices.rows());
  const auto added = static_cast<int>(quads.points.size()) - quads.loop;
  cage.vertices.conservativeResize(before + added, Eigen::NoChange);
  for (int i = 0; i < added; ++i) {
    cage.vertices.row(before + i) = quads.points[quads.loop + i];
    number.push_back(before + i);
    filled.vertices.push_back(before + i);
  }
  for (const std::array<int, 4>& quad : quads.quads) {
    filled.faces.push_back(static_cast<int>(cage.faces.size()));
    cage.faces.push_back({number[quad[0]], number[quad[1]], number[quad[2]], number[quad[3]]});
  }
  add_group(cage, {filled.rim_group, filled.rim});
  add_group(cage, {filled.group, filled.faces});
  return filled;
}

/// An edge with more than two faces, which a grid without vertices inside may make.
std::optional<Error> check_edges(const Cage& cage) {
  const std::vector<EdgeUse> uses = edge_uses(cage);
  for (std::size_t i = 2; i < uses.size(); ++i) {
    if (!same_edge(uses[i - 2], uses[i])) continue;
    return Error{fmt::format("vertices {} and {}, which the fill would join, are joined already", uses[i].low + 1,
                             uses[i].high + 1)};
  }
  return std::nullopt;
}

}  // namespace

Result<FilledCage> fill(const Cage& cage, const FillOptions& options) {
  const std::vector<Loop> loops = surface_boundaries(cage);
  const Result<std::vector<int>> chosen = chosen_loops(options, static_cast<int>(loops.size()));
  if (!chosen) return chosen.error();
  std::vector<Task> tasks;
  for (const int loop : *chosen) {
    tasks.push_back({loop, loops[loop], {}, {}});
    turn(tasks.back().loop);
    if (loops[loop].size() > kLongestFilledLoop) {
      return tasks.back().error(
          fmt::format("has {} edges; at most {} are filled", loops[loop].size(), kLongestFilledLoop));
    }
  }
  if (auto error = mark_corners(options, tasks)) return *error;

  FilledCage result;
  result.cage = cage;
  open_holes(result, tasks);
  const auto patterns_of = [&](const Arrival& arrival) {
    std::vector<std::optional<FillPattern>> patterns;
    for (const Task& task : tasks) patterns.push_back(pattern_of(task, result.cage, arrival));
    return patterns;
  };
  for (Task& task : tasks) task.rim = faces_around(task.loop, result.cage);
  Arrival arrival(result.cage);
  std::vector<std::optional<FillPattern>> patterns = patterns_of(arrival);
  if (const auto none = std::find(patterns.begin(), patterns.end(), std::nullopt); none != patterns.end()) {
    result.refined = why_refined(tasks[none - patterns.begin()]);
    number_quads(result);
    const bool rest = leave_a_rest(tasks, result.cage);
    for (Task& task : tasks) task.rim = children_of(task.rim, result.cage);
    result.cage = refined(result.cage);
    for (Task& task : tasks) {
      task.loop = refined_loop(task.loop, result.cage);
      if (!rest) task.rim = faces_around(task.loop, result.cage);
    }
    arrival = Arrival(result.cage);
    patterns = patterns_of(arrival);
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    Result<FilledLoop> filled = add(tasks[i], *patterns[i], arrival, result.cage);
    if (!filled) return filled.error();
    result.loops.push_back(*std::move(filled));
  }
  if (auto error = check_edges(result.cage)) return *error;
  return result;
}

}  // namespace umbilic
