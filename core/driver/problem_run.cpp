// SPDX-License-Identifier: MIT
/// \file
/// Makes the cage, refines it to the level where the problem starts, and begins the run.
#include "driver/problem_run.h"

#include "base/instruction_set.h"
#include "problem/cage_of.h"

namespace umbilic {
namespace {

Result<Run> run_of(const Problem& problem, const Cage& cage) {
  if (!problem.start) return Run::create(cage, problem.options);
  const Result<SymmetricCage> start = symmetric_cage(cage, problem.start->level, problem.start->points);
  if (!start) return Error{"start: " + start.error().message};
  return Run::create(*start, problem.options);
}

}  // namespace

Report ProblemRun::report() const {
  Report report;
  report.instruction_set = std::string(name_of(instruction_set()));
  report.problem = problem;
  report.cage = cage;
  report.group = run.group();
  report.levels = run.levels();
  report.limit = run.limit();
  report.energies = run.energies();
  report.surface = run.state();
  return report;
}

Result<ProblemRun> begin_run(Problem problem) {
  const Result<CheckedCage> cage = cage_of(problem.cage);
  if (!cage) return cage.error();
  Result<Run> run = run_of(problem, cage->cage);
  if (!run) return named(problem.cage, run.error());
  return ProblemRun{std::move(problem), cage->report, std::move(run).value()};
}

}  // namespace umbilic
