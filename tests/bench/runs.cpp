// SPDX-License-Identifier: MIT
/// \file
/// One run from its cage to its end, with the moment and the energy of every evaluation; a process for each run, so
/// that nothing is left over from another one.
#include <chrono>
#include <cmath>
#include <ctime>
#include <tuple>

#include "cage/write.h"
#include "cages.h"
#include "driver/run.h"
#include "subjects.h"

namespace umbilic {
namespace {

template <class Names>
int index_of(std::string_view name, const Names& names) {
  int i = 0;
  for (const std::string_view candidate : names) {
    if (candidate == name) return i;
    ++i;
  }
  return -1;
}

std::string row_of(const LevelReport& level) {
  return fmt::format(
      R"({{"level":{},"patches":{},"unknowns":{},"energy":{:.10g},"energyReported":{:.10g},"iterations":{},)"
      R"("evaluations":{},"metric":"{}","metrics":{},"seconds":{:.6g},"stop":"{}"}})",
      level.level, level.patches, level.unknowns, level.energy, level.energy_reported, level.iterations,
      level.evaluations, name_of(level.metric), level.metrics, level.seconds, name_of(level.stop));
}

}  // namespace

std::string cage_text(const std::vector<std::string>& arguments) {
  const Result<Cage> cage = arguments.size() == 1 ? bench_cage(arguments[0]) : Error{};
  return cage ? write_obj(*cage) : "";
}

std::string whole_run(const std::vector<std::string>& arguments) {
  if (arguments.size() != 5) return "";
  const auto& [cage, functional, levels, metric, symmetry] =
      std::tie(arguments[0], arguments[1], arguments[2], arguments[3], arguments[4]);
  const int objective = index_of(functional, kFunctionalNames), choice = index_of(metric, kMetricChoiceNames);
  const Result<Cage> start = bench_cage(cage);
  if (!start || objective < 0 || choice < 0) return "";
  RunOptions options;
  options.weights = only(objective);
  options.metric = static_cast<MetricChoice>(choice);
  options.symmetry = symmetry == "symmetric";
  options.last_level = std::stoi(levels);

  const std::clock_t cpu_begin = std::clock();
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::string> steps;
  Run run = *Run::create(*start, options);
  const Estimate estimate = run.estimate();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  for (bool done = false; !done;) {
    done = run.step(1);
    const Progress& progress = run.progress();
    if (std::isfinite(progress.energy)) {
      steps.push_back(fmt::format("[{:.6g},{:.6g},{:.10g}]", seconds(),
                                  static_cast<double>(std::clock()) / CLOCKS_PER_SEC, progress.energy));
    }
  }
  const double total = seconds();
  const double cpu = static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
  std::vector<std::string> rows, expected;
  for (const LevelReport& level : run.levels()) rows.push_back(row_of(level));
  for (const LevelEstimate& level : estimate.levels) {
    expected.push_back(fmt::format(R"({{"level":{},"unknowns":{},"evaluations":{},"seconds":{:.6g}}})", level.level,
                                   level.unknowns, level.evaluations, level.seconds));
  }
  return fmt::format(
      R"({{"seconds":{:.6g},"cpuSeconds":{:.6g},"group":"{}","order":{},"levels":{},"estimate":{},"steps":{}}})", total,
      cpu, run.group().name, run.group().order, joined(rows), joined(expected), joined(steps));
}

}  // namespace umbilic
