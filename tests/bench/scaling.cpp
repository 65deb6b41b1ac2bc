// SPDX-License-Identifier: MIT
/// \file
/// An evaluation, and a level's whole solve, as the mesh is refined: bending of the genus-2 frame without symmetry.
#include <chrono>

#include "driver/run.h"
#include "measure.h"
#include "subjects.h"

namespace umbilic {
namespace {

constexpr int kFirstLevel = 2;  // 384 patches
constexpr int kLastLevel = 5;   // 24576

double evaluation_seconds(const Cage& cage) {
  RefinedCage refined = *refine_to_evaluable(cage, 0, false);
  const Points control = refined.control;
  const Surface surface(std::move(refined), CapKind::kSmooth, only(kBending));
  Points gradient;
  return best_seconds([&] { surface.energy().evaluate(control, &gradient); }, 0.5, 5);
}

RunOptions bending_options(int first_level, int last_level) {
  RunOptions options;
  options.weights = only(kBending);
  options.symmetry = false;
  options.first_level = first_level;
  options.last_level = last_level;
  return options;
}

Run solved(const Cage& cage, const RunOptions& options) {
  Run run = *Run::create(cage, options);
  while (!run.step(1000)) {
  }
  return run;
}

}  // namespace

std::string scaling() {
  std::vector<std::string> rows;
  Cage cage = solved(*generate_cage("two-3"), bending_options(0, kFirstLevel - 1)).control_mesh();
  for (int level = kFirstLevel; level <= kLastLevel; ++level) {
    const auto begin = std::chrono::steady_clock::now();
    const Run run = solved(cage, bending_options(1, 1));
    const double solve = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    cage = run.control_mesh();
    const LevelReport& report = run.levels().back();
    rows.push_back(
        fmt::format(R"({{"patches":{},"unknowns":{},"evaluationSeconds":{:.6g},"solveSeconds":{:.6g},"evaluations":{},)"
                    R"("metric":"{}","metrics":{},"stop":"{}","energy":{:.10g}}})",
                    report.patches, report.unknowns, evaluation_seconds(cage), solve, report.evaluations,
                    name_of(report.metric), report.metrics, name_of(report.stop), report.energy_reported));
  }
  return joined(rows);
}

}  // namespace umbilic
