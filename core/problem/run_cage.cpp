// SPDX-License-Identifier: MIT
/// \file
/// Fills, finds the elements again that the constraints number, and says what was done.
#include "problem/run_cage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cage/boundary.h"
#include "cage/count.h"
#include "cage/edges.h"
#include "cage/fill.h"
#include "cage/text.h"
#include "problem/cage_of.h"
#include "problem/face_selection.h"

namespace umbilic {
namespace {

/// The options of the request, with the loop of each corner.
Result<FillOptions> options_of(const FillRequest& request, const Cage& cage) {
  const std::vector<std::vector<int>> loops = surface_boundaries(cage);
  FillOptions options;
  for (std::size_t i = 0; i < request.loops.size(); ++i) {
    const int number = request.loops[i];
    if (number < 1 || number > static_cast<int>(loops.size())) {
      return Error{loops.empty() ? "fill: the cage is closed, and has no boundary to fill"
                                 : fmt::format("fill.loops[{}]: there is no boundary {}; the cage has {}", i, number,
                                               loops.size())};
    }
    options.loops.push_back(number - 1);
  }
  for (std::size_t i = 0; i < request.corners.size(); ++i) {
    const int vertex = request.corners[i] - 1;
    const auto passes = [&](const std::vector<int>& loop) {
      return std::find(loop.begin(), loop.end(), vertex) != loop.end();
    };
    const auto found = std::find_if(loops.begin(), loops.end(), passes);
    if (found == loops.end()) {
      return Error{fmt::format("fill.corners[{}]: vertex {} is on no boundary of the cage", i, vertex + 1)};
    }
    const auto loop = static_cast<int>(found - loops.begin());
    const auto known = std::find_if(options.corners.begin(), options.corners.end(),
                                    [&](const FillCorners& corners) { return corners.loop == loop; });
    (known == options.corners.end() ? options.corners.emplace_back(FillCorners{loop, {}}) : *known)
        .vertices.push_back(vertex);
  }
  return options;
}

/// The faces that `selection` numbers, as they are numbered now.
Result<FaceSelection> renumbered(const FaceSelection& selection, std::string_view member, const Cage& before,
                                 const FilledCage& filled) {
  if (const auto known = selected_faces(before, {{}, selection.faces}, member); !known) return known.error();
  FaceSelection result{selection.groups, {}};
  for (const int face : selection.faces) {
    const int first = filled.face_numbers[face - 1];
    if (first < 0) continue;
    const int count = filled.refined ? static_cast<int>(before.faces[face - 1].size()) : 1;
    for (int i = 0; i < count; ++i) result.faces.push_back(first + i + 1);
  }
  return result;
}

/// In the quad around a corner of a face that was refined, the place that was (u, v) of the face.
void refine_place(Pin& pin, int size, int first) {
  int corner = pin.corner.value_or(1) - 1;
  std::array<double, 2>& uv = *pin.uv;
  if (size == 4) {
    const auto [u, v] = uv;
    corner = v <= 0.5 ? (u <= 0.5 ? 0 : 1) : (u > 0.5 ? 2 : 3);
    const std::array<double, 2> from_corner[]{{u, v}, {v, 1 - u}, {1 - u, 1 - v}, {1 - v, u}};
    uv = {2 * from_corner[corner][0], 2 * from_corner[corner][1]};
  }
  pin.corner.reset();
  pin.face = first + corner + 1;
}

/// The pin on the filled cage. One that is out of range is left so.
Result<Pin> renumbered(Pin pin, std::size_t index, const Cage& before, const FilledCage& filled) {
  const auto gone = [&](std::string_view what, int number) {
    return Error{fmt::format("constraints.pins[{}].{}: {} was part of a hole, which is filled", index, what, number)};
  };
  if (Error error; !in_range(pin, error)) return Error{fmt::format("constraints.pins[{}].{}", index, error.message)};
  const auto missing = [&](std::string_view what, std::string_view many, int number, std::size_t count) {
    return Error{fmt::format("constraints.pins[{}].{}: {}, but the cage has {} {}", index, what, number, count, many)};
  };
  if (pin.vertex) {
    if (*pin.vertex > before.vertices.rows()) {
      return missing("vertex", "vertices", *pin.vertex, static_cast<std::size_t>(before.vertices.rows()));
    }
    const int number = filled.vertex_numbers[*pin.vertex - 1];
    if (number < 0) return gone("vertex", *pin.vertex);
    pin.vertex = number + 1;
    return pin;
  }
  if (*pin.face > static_cast<int>(before.faces.size())) {
    return missing("face", "faces", *pin.face, before.faces.size());
  }
  const int number = filled.face_numbers[*pin.face - 1], size = static_cast<int>(before.faces[*pin.face - 1].size());
  if (number < 0) return gone("face", *pin.face);
  if (!filled.refined) {
    pin.face = number + 1;
  } else if (size == 4 ? !pin.corner : pin.corner && *pin.corner <= size) {
    refine_place(pin, size, number);
  } else {
    return Error{
        fmt::format("constraints.pins[{}].corner: face {} has {} corners; those of a quad are not named, "
                    "others must be, from 1 on",
                    index, *pin.face, size)};
  }
  return pin;
}

/// The pin where validation may have turned its face, which begins with the same corner then.
void turn_place(Pin& pin, const Cage& filled, const Cage& validated) {
  if (!pin.face) return;
  const std::vector<int>& face = validated.faces[*pin.face - 1];
  if (face == filled.faces[*pin.face - 1]) return;
  std::swap((*pin.uv)[0], (*pin.uv)[1]);
  if (pin.corner && *pin.corner > 1) pin.corner = static_cast<int>(face.size()) + 2 - *pin.corner;
}

/// The condition of a boundary that stays, which has a smaller number where others before it are filled. One that is
/// out of range is left so.
Result<LoopCondition> renumbered(LoopCondition condition, std::size_t index, const FilledCage& filled) {
  const int number = condition.loop;
  for (const FilledLoop& loop : filled.loops) {
    if (loop.loop + 1 == number) {
      return Error{fmt::format("constraints.boundary.loops[{}].loop: boundary {} is filled", index, number)};
    }
    condition.loop -= loop.loop + 1 < number;
  }
  for (std::optional<int>* vertex : {&condition.from, &condition.to}) {
    if (!*vertex || **vertex < 1 || **vertex > static_cast<int>(filled.vertex_numbers.size())) continue;
    *vertex = filled.vertex_numbers[**vertex - 1] + 1;
  }
  return condition;
}

Result<Constraints> renumbered(const Constraints& constraints, const Cage& before, const FilledCage& filled) {
  Constraints result = constraints;
  for (const auto& [member, selection] : {std::pair("hold", &result.hold), std::pair("free", &result.free)}) {
    if (!*selection) continue;
    Result<FaceSelection> faces = renumbered(**selection, member, before, filled);
    if (!faces) return faces.error();
    *selection = std::move(faces).value();
  }
  for (std::size_t i = 0; i < result.pins.size(); ++i) {
    Result<Pin> pin = renumbered(result.pins[i], i, before, filled);
    if (!pin) return pin.error();
    result.pins[i] = *pin;
  }
  for (std::size_t i = 0; result.boundary && i < result.boundary->loops.size(); ++i) {
    Result<LoopCondition> condition = renumbered(result.boundary->loops[i], i, filled);
    if (!condition) return condition.error();
    result.boundary->loops[i] = *condition;
  }
  return result;
}

/// All groups of the fills.
FaceSelection fills(const FilledCage& filled) {
  FaceSelection selection;
  for (const FilledLoop& loop : filled.loops) {
    selection.groups.push_back(loop.group);
    selection.groups.push_back(loop.rim_group);
  }
  return selection;
}

/// Whether a face of the surface touches no filled loop.
bool has_rest(const FilledCage& filled) {
  std::vector<bool> free(filled.cage.faces.size(), false);
  for (const FilledLoop& loop : filled.loops) {
    for (const int f : loop.faces) free[f] = true;
    for (const int f : loop.rim) free[f] = true;
  }
  for (const int f : filled.cage.holes) free[f] = true;
  return std::find(free.begin(), free.end(), false) != free.end();
}

std::vector<std::string> notes_of(const FilledCage& filled) {
  std::vector<std::string> notes;
  for (const FilledLoop& loop : filled.loops) {
    notes.push_back(fmt::format("filled boundary {} of {} vertices with {} faces, the group {}", loop.loop + 1,
                                loop.edges, loop.faces.size(), in_quotes(loop.group)));
  }
  if (filled.refined) notes.front() += fmt::format("; the cage was refined once first, because {}", *filled.refined);
  return notes;
}

Result<RunCage> filled_cage(Problem& problem, CheckedCage made) {
  const Result<FillOptions> options = options_of(*problem.fill, made.cage);
  if (!options) return options.error();
  Result<FilledCage> filled = fill(made.cage, *options);
  if (!filled) return Error{"fill: " + filled.error().message};
  Cage cage = filled->cage;
  Result<CageReport> report = validate(cage);
  if (!report) return Error{"fill: " + report.error().message};

  std::vector<std::string> notes = std::move(made.report.notes);
  for (std::string& note : notes_of(*filled)) notes.push_back(std::move(note));
  for (std::string& note : report->notes) {
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
  }
  if (!problem.constraints.holds_faces()) {
    if (!has_rest(*filled)) {
      return Error{
          "fill: every face of the cage touches a filled boundary, and its surface depends on the fill: there is "
          "nothing to hold. \"hold\": {} in the constraints holds nothing"};
    }
    problem.constraints.free = fills(*filled);
    notes.push_back(fmt::format("held is what is not filled and touches no filled boundary: all but the groups {}",
                                fmt::join(problem.constraints.free->groups, ", ")));
  }
  report->notes = std::move(notes);
  report->repairs.insert(report->repairs.begin(), made.report.repairs.begin(), made.report.repairs.end());
  Result<Constraints> constraints = renumbered(problem.constraints, made.cage, *filled);
  if (!constraints) return constraints.error();
  for (Pin& pin : constraints->pins) turn_place(pin, filled->cage, cage);
  return RunCage{std::move(cage), *std::move(report), *std::move(constraints)};
}

/// Where holes meet at a vertex only, its boundaries are no loops.
std::optional<Error> check_fans(const Cage& surface) {
  const std::vector<int> fans = fan_counts(surface, edge_uses(surface));
  const auto pinched = std::find_if(fans.begin(), fans.end(), [](int count) { return count > 1; });
  if (pinched == fans.end()) return std::nullopt;
  return Error{fmt::format("vertex {} joins {} fans of faces with holes between them: not a manifold",
                           pinched - fans.begin() + 1, *pinched)};
}

/// Faces that are holes by the constraints. The report then counts the others.
std::optional<Error> mark_holes(const Constraints& constraints, CheckedCage& made) {
  if (!constraints.holes) return std::nullopt;
  Cage& cage = made.cage;
  const Result<std::vector<bool>> holes = selected_faces(cage, *constraints.holes, "holes");
  if (!holes) return holes.error();
  cage.holes.clear();
  for (std::size_t f = 0; f < holes->size(); ++f) {
    if ((*holes)[f]) cage.holes.push_back(static_cast<int>(f));
  }
  if (cage.holes.size() == cage.faces.size()) return Error{"constraints.holes: all faces are holes"};
  if (auto error = check_fans(without_holes(cage))) return error;
  CageReport counts = count(cage);
  for (CageBoundary& boundary : counts.boundaries) ++boundary.first_vertex;
  counts.repairs = std::move(made.report.repairs);
  counts.notes = std::move(made.report.notes);
  made.report = std::move(counts);
  return std::nullopt;
}

}  // namespace

Result<CheckedCage> cage_with_holes(const Problem& problem) {
  Result<CheckedCage> made = cage_of(problem.cage);
  if (!made) return made.error();
  if (auto error = mark_holes(problem.constraints, *made)) return named(problem.cage, *error);
  return made;
}

Result<RunCage> run_cage(Problem& problem) {
  Result<CheckedCage> made = cage_with_holes(problem);
  if (!made) return made.error();
  Result<RunCage> result = problem.fill ? filled_cage(problem, *std::move(made))
                                        : RunCage{std::move(made->cage), std::move(made->report), problem.constraints};
  if (!result) return named(problem.cage, result.error());
  return result;
}

}  // namespace umbilic
