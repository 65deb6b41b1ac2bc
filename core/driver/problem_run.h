// SPDX-License-Identifier: MIT
/// \file
/// A run with the problem that it answers: from a `Problem` to a `Report`.
#pragma once

#include "driver/run.h"
#include "problem/problem.h"
#include "problem/report.h"

namespace umbilic {

struct ProblemRun {
  Problem problem;
  CageReport cage;
  Run run;

  /// Of the best surface so far; `program` and `certificate` are left to those who have them.
  Report report() const;
};

/// Fails where the cage cannot be made (problem/cage_of.h), where the points of `start` do not fit it, and as
/// `Run::create`.
Result<ProblemRun> begin_run(Problem problem);

}  // namespace umbilic
