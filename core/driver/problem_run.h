// SPDX-License-Identifier: MIT
/// \file
/// A run together with its problem: from a `Problem` to a `Report`.
#pragma once

#include <vector>

#include "cage/cage.h"
#include "driver/run.h"
#include "problem/problem.h"
#include "problem/report.h"

namespace umbilic {

struct ProblemRun {
  Problem problem;  ///< with what is held on account of its fill
  CageReport cage;  ///< of the cage after filling
  Run run;
  std::vector<FaceGroup> groups{};  ///< of the cage

  /// As Run::retarget; the problem then has the new targets. Points are those of the problem's cage: it becomes a text,
  /// without a start, and is filled as for a new run. Fails, too, where its fill then has other faces.
  std::optional<Error> retarget(const Targets& targets);
  /// Report on the best surface so far. The caller fills in `program` and `certificate`.
  Report report() const;
};

/// Fails if the cage cannot be made (problem/run_cage.h) or the points of `start` do not fit it, and as `Run::create`.
Result<ProblemRun> begin_run(Problem problem);

}  // namespace umbilic
