// SPDX-License-Identifier: MIT
/// \file
/// Makes the cage and begins the run.
#include "driver/problem_run.h"

#include "base/instruction_set.h"
#include "problem/cage_of.h"
#include "problem/run_cage.h"

namespace umbilic {

std::optional<Error> ProblemRun::retarget(const Targets& targets) {
  if (auto error = run.retarget(targets)) return error;
  return set_targets(targets, problem.options, problem.constraints);
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
