// SPDX-License-Identifier: MIT
/// \file
/// Declares each flag with its parser and what it sets.
#include "cli/problem_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cage/text.h"
#include "cli/arguments.h"

namespace umbilic::cli {

namespace {

constexpr const char* kAll = "all";

Result<double> parse_tolerance(const std::string& text) {
  const Result<double> number = parse_real(text);
  if (number && *number < 0) return Error{fmt::format("{} is negative", in_quotes(text))};
  return number;
}

Result<double> parse_positive(const std::string& text) {
  const Result<double> number = parse_real(text);
  if (number && !(*number > 0)) return Error{fmt::format("{} is not a number > 0", in_quotes(text))};
  return number;
}

/// "draft", "good", "fine" or "2%".
Result<double> parse_accuracy(const std::string& text) {
  constexpr std::pair<std::string_view, double> kNamed[]{{"draft", 0.05}, {"good", 0.01}, {"fine", 0.003}};
  for (const auto& [name, part] : kNamed) {
    if (name == text) return part;
  }
  const Result<double> percent =
      text.ends_with('%') ? parse_real(text.substr(0, text.size() - 1)) : Error{"no percent sign"};
  if (percent && *percent > 0 && *percent < 100) return *percent / 100;
  return Error{fmt::format("{} is none of draft, good, fine, nor a percentage as in 2%", in_quotes(text))};
}

Result<int> parse_iterations(const std::string& text) { return parse_count(text, 0, std::numeric_limits<int>::max()); }

Result<BoundaryCondition> parse_boundary(const std::string& text) {
  for (int i = 0; !name_of(static_cast<BoundaryCondition>(i)).empty(); ++i) {
    if (name_of(static_cast<BoundaryCondition>(i)) == text) return static_cast<BoundaryCondition>(i);
  }
  return Error{fmt::format("{} is none of free, position, tangent, curvature", in_quotes(text))};
}

/// "17", "17@0,0.5,1", "17:normal". Other pins are written in a problem's file.
Result<Pin> parse_pin(const std::string& text) {
  Pin pin;
  std::string rest = text;
  constexpr std::string_view kNormal = ":normal";
  if (rest.size() > kNormal.size() && std::string_view(rest).substr(rest.size() - kNormal.size()) == kNormal) {
    pin.normal = true;
    rest.resize(rest.size() - kNormal.size());
  }
  const std::size_t at = rest.find('@');
  const Result<int> vertex = parse_count(rest.substr(0, at), 1, std::numeric_limits<int>::max());
  if (!vertex) return vertex.error();
  pin.vertex = *vertex;
  if (at == rest.npos) return pin;
  std::size_t begin = at + 1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? rest.find(',', begin) : rest.size();
    if (end == rest.npos) return Error{fmt::format("{} has no three coordinates behind @", in_quotes(text))};
    const Result<double> number = parse_real(rest.substr(begin, end - begin));
    if (!number) return number.error();
    if (!pin.at) pin.at.emplace();
    (*pin.at)[axis] = *number;
    begin = end + 1;
  }
  return pin;
}

/// Adds an option that changes the problem if it is given.
template <class Parse, class Apply>
CLI::Option* add_change(CLI::App& command, const std::shared_ptr<ProblemChanges>& changes, const char* name,
                        const char* type, const char* words, const Parse& parse, const Apply& apply) {
  return command
      .add_option_function<std::string>(
          name,
          [changes, parse, apply](const std::string& text) {
            const auto value = parse(text).value();
            changes->push_back([value, apply](Problem& problem) { apply(problem, value); });
          },
          words)
      ->type_name(type)
      ->check(checked(parse));
}

/// Adds an option that adds a group of faces to a selection each time that it is given.
template <class Selection>
void add_groups(CLI::App& command, const std::shared_ptr<ProblemChanges>& changes, const char* name, const char* words,
                const Selection& selection) {
  const auto add = [changes, selection](const std::vector<std::string>& groups) {
    changes->push_back([groups, selection](Problem& problem) {
      std::optional<FaceSelection>& faces = selection(problem.constraints);
      if (!faces) faces.emplace();
      faces->groups.insert(faces->groups.end(), groups.begin(), groups.end());
    });
  };
  command.add_option_function<std::vector<std::string>>(name, add, words)->type_name("GROUP")->expected(1)->take_all();
}

/// Numbers of boundaries separated by commas; none for all of them.
Result<std::vector<int>> parse_loops(const std::string& text) {
  std::vector<int> loops;
  if (text == kAll) return loops;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const Result<int> loop = parse_count(text.substr(begin, comma - begin), 1, std::numeric_limits<int>::max());
    if (!loop) {
      return Error{
          fmt::format("{} is not all, nor numbers of boundaries as in 1,3 (where INPUT follows, write --fill=all)",
                      in_quotes(text))};
    }
    loops.push_back(*loop);
    begin = comma + 1;
  }
  return loops;
}

void add_fill(CLI::App& command, const std::shared_ptr<ProblemChanges>& changes) {
  const auto set = [](Problem& problem, const std::vector<int>& loops) {
    if (!problem.fill) problem.fill.emplace();
    problem.fill->loops = loops;
  };
  add_change(command, changes, "--fill", "LOOPS",
             "Close these boundaries with quads, numbered as `info` does (1,3), or all; what\n"
             "neither fills nor touches them is held, unless --hold or --free say otherwise",
             parse_loops, set)
      ->expected(0, 1)
      ->default_str(kAll);
}

}  // namespace

void add_problem_options(CLI::App& command, const std::shared_ptr<ProblemChanges>& changes) {
  const auto set_weights = [](Problem& problem, const Weights& weights) { problem.options.weights = weights; };
  CLI::Option* functional = add_change(
      command, changes, "--functional", "NAME", kFunctionalWords,
      [](const std::string& name) { return weights_of(name); }, set_weights);
  add_change(
      command, changes, "--weights", "SUM", kWeightsWords, [](const std::string& text) { return parse_weights(text); },
      set_weights)
      ->excludes(functional);
  add_change(command, changes, "--cap", "CAP", kCapWords, parse_cap,
             [](Problem& problem, CapKind cap) { problem.options.cap = cap; });
  add_change(command, changes, "--cap-rings", "R", kCapRingsWords, parse_cap_rings,
             [](Problem& problem, int rings) { problem.options.cap_rings = rings; });
  add_change(
      command, changes, "--levels", "A..B",
      "Minimize, subdivide, minimize: from A to B Catmull-Clark steps of the cage;\n"
      "where the cage is too coarse to be evaluated, a finer mesh is [0..2]",
      [](const std::string& text) { return parse_levels(text); },
      [](Problem& problem, const LevelRange& range) {
        problem.options.first_level = range.first;
        problem.options.last_level = range.last;
      });
  add_change(command, changes, "--max-iterations", "N", "Most iterations per level [1000]", parse_iterations,
             [](Problem& problem, int most) { problem.options.max_iterations = most; });
  add_change(command, changes, "--tolerance", "T",
             "A level ends when the decrease still predicted is below\nT * max(energy, 1e-6 * 8 pi) [1e-6]",
             parse_tolerance, [](Problem& problem, double tolerance) { problem.options.tolerance = tolerance; });
  add_change(command, changes, "--accuracy", "A",
             "Levels and tolerance as they are needed to know the limit within A: draft (5%), good (1%), fine (0.3%),\n"
             "or X%; at most six levels",
             parse_accuracy, [](Problem& problem, double accuracy) { problem.options.accuracy = accuracy; });
  command.add_flag(
      "--second-opinion",
      [changes](std::int64_t) { changes->push_back([](Problem& problem) { problem.options.second_opinion = true; }); },
      "Compute the energies of the result in another way, too, which takes seconds");
  command.add_flag(
      "--no-symmetry",
      [changes](std::int64_t) { changes->push_back([](Problem& problem) { problem.options.symmetry = false; }); },
      "Let the surface leave the cage's symmetry");
  add_change(command, changes, "--metric", "NAME",
             "What the optimizer measures steps with: auto, identity, sobolev, hessian or newton [auto]", parse_metric,
             [](Problem& problem, MetricChoice metric) { problem.options.metric = metric; });
  command
      .add_option_function<std::vector<std::string>>(
          "--pin",
          [changes](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const Pin pin = parse_pin(text).value();
              changes->push_back([pin](Problem& problem) { problem.constraints.pins.push_back(pin); });
            }
          },
          "Hold the surface's point at a vertex (numbered from 1) where it is, or at X,Y,Z; with :normal\n"
          "its normal too; may be repeated")
      ->type_name("V[@X,Y,Z][:normal]")
      ->expected(1)
      ->take_all()
      ->check(checked(parse_pin));
  add_change(command, changes, "--boundary", "CONDITION",
             "What is held at the boundaries of an open surface: free, position, tangent or curvature [tangent]",
             parse_boundary, [](Problem& problem, BoundaryCondition condition) {
               problem.constraints.boundary = BoundaryConditions{condition, {}};
             });
  add_change(command, changes, "--within", "DISTANCE",
             "Pull the surface to the cage's own, as little as keeps every point within this distance of it",
             parse_positive, [](Problem& problem, double distance) {
               problem.constraints.closeness = Closeness{{}, distance};
             });
  add_change(command, changes, "--closeness", "W",
             "Pull the surface to the cage's own with W * integral of |X - X0|^2 dA", parse_tolerance,
             [](Problem& problem, double weight) {
               problem.constraints.closeness = Closeness{weight, {}};
             });
  add_groups(command, changes, "--hold",
             "Hold the faces of this group of the file: their surface stays; may be repeated",
             [](Constraints& constraints) -> std::optional<FaceSelection>& { return constraints.hold; });
  add_groups(command, changes, "--free", "Let only the faces of this group move; may be repeated",
             [](Constraints& constraints) -> std::optional<FaceSelection>& { return constraints.free; });
  add_groups(command, changes, "--holes",
             "No surface over the faces of this group, which say how it goes on beyond its boundary; may be repeated",
             [](Constraints& constraints) -> std::optional<FaceSelection>& { return constraints.holes; });
  command.add_flag(
      "--hold-symmetric",
      [changes](std::int64_t) { changes->push_back([](Problem& problem) { problem.constraints.symmetric = true; }); },
      "Copy pins, and what --hold or --free name, to all places to which the cage's symmetry maps\n"
      "theirs, so that the symmetry is kept");
  add_fill(command, changes);
}

}  // namespace umbilic::cli
