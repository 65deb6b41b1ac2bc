// SPDX-License-Identifier: MIT
/// \file
/// Makes the cage and begins the run.
#include "driver/problem_run.h"

#include <string>
#include <utility>
#include <variant>

#include "base/instruction_set.h"
#include "cage/with_points.h"
#include "cage/write.h"
#include "problem/cage_of.h"
#include "problem/run_cage.h"

namespace umbilic {

namespace {

/// The problem with other points of its cage. A start, which fits the cage before, is left out.
Result<Problem> moved(const Problem& problem, const Points& points) {
  Result<CheckedCage> made = cage_of(problem.cage);
  if (!made) return made.error();
  const Result<Cage> cage = with_points(std::move(made->cage), points);
  if (!cage) return cage.error();
  Problem result = problem;
  const auto* text = std::get_if<CageText>(&problem.cage);
  result.cage = CageText{text ? text->name : std::string(), write_obj(*cage)};
  if (!cage->holes.empty() && !result.constraints.holes) {
    result.constraints.holes.emplace();
    for (const int face : cage->holes) result.constraints.holes->faces.push_back(face + 1);
  }
  result.start.reset();
  return result;
}

}  // namespace

std::optional<Error> ProblemRun::retarget(const Targets& targets) {
  Problem next = problem;
  Targets of_run = targets;
  if (targets.points) {
    Result<Problem> other = moved(problem, *targets.points);
    if (!other) return other.error();
    next = *std::move(other);
    Result<RunCage> filled = run_cage(next);
    if (!filled) return filled.error();
    if (filled->cage.faces != run.cage().faces) {
      return Error{"points: the boundaries would be filled with other faces; that takes a new run"};
    }
    of_run.points = std::move(filled->cage.vertices);
  }
  if (auto error = run.retarget(of_run)) return error;
  if (auto error = set_targets(targets, next.options, next.constraints)) return error;
  problem = std::move(next);
  return std::nullopt;
}

Report ProblemRun::report() const {
  Report report;
  report.instruction_set = std::string(name_of(instruction_set()));
  report.problem = problem;
  report.cage = cage;
  report.group = run.group();
  report.estimate = run.estimate();
  report.levels = run.levels();
  report.limit = run.limit();
  report.energies = run.energies();
  if (problem.options.second_opinion) report.second_opinion = run.second_opinion();
  report.constraints = run.constraints();
  report.surface = run.state();
  return report;
}

Result<ProblemRun> begin_run(Problem problem) {
  Result<RunCage> cage = run_cage(problem);
  if (!cage) return cage.error();
  Result<Run> run = Run::create(cage->cage, problem.options, cage->constraints, problem.start);
  if (!run) return named(problem.cage, run.error());
  return ProblemRun{std::move(problem), std::move(cage->report), std::move(run).value(), std::move(cage->cage.groups)};
}

}  // namespace umbilic
