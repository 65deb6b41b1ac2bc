// SPDX-License-Identifier: MIT
/// \file
/// What the CPU time of whole runs goes into: how often each part of a level is done times what it takes alone.
#include <array>
#include <ctime>
#include <tuple>

#include "cages.h"
#include "driver/run.h"
#include "parts.h"
#include "peak.h"
#include "subjects.h"

namespace umbilic {
namespace {

struct Share {
  const char* name;
  double seconds = 0;
  double flops = 0;  ///< 0 where they are not counted
};

std::array<Share, 7> shares_of(const LevelReport& level, const LevelParts& parts) {
  const bool sobolev = level.metric == MetricChoice::kSobolev;
  const double factorizations = sobolev ? 0 : level.factorizations;
  return {{{"set-up", parts.refining + parts.layout},
           {"energy and gradient", level.evaluations * parts.evaluation, level.evaluations * parts.evaluation_flops},
           {"second derivatives", sobolev ? 0 : level.metrics * parts.assembly},
           {"factorization", factorizations * parts.factorization, factorizations * parts.factorization_flops},
           {"solution", sobolev ? 0 : level.iterations * parts.solution},
           {"Sobolev metric", sobolev ? level.metrics * parts.sobolev : 0},
           {"report", parts.report}}};
}

std::string shares_row(const std::string& name, bool symmetric, int functional, int last_level) {
  const Cage cage = *bench_cage(name);
  RunOptions options;
  options.weights = only(functional);
  options.symmetry = symmetric;
  options.last_level = last_level;
  const std::clock_t begin = std::clock();
  Run run = *Run::create(cage, options);
  while (!run.step(1)) {
  }
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;

  std::array<Share, 7> sums{};
  for (const LevelReport& level : run.levels()) {
    const auto shares = shares_of(level, measure_parts(cage, symmetric, level.level, options.weights));
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] = {shares[i].name, sums[i].seconds + shares[i].seconds, sums[i].flops + shares[i].flops};
    }
  }
  std::vector<std::string> parts;
  for (const Share& share : sums) {
    parts.push_back(
        fmt::format(R"({{"part":"{}","seconds":{:.4g},"flops":{:.4g}}})", share.name, share.seconds, share.flops));
  }
  return fmt::format(
      R"({{"cage":"{}","symmetric":{},"functional":"{}","level":{},"seconds":{:.4g},"peak":{:.4g},"parts":{}}})", name,
      symmetric, kFunctionalNames[functional], last_level, seconds, peak_flops_per_second(), joined(parts));
}

}  // namespace

std::string shares() {
  return joined({shares_row("two-3", true, kBending, 3), shares_row("two-3", true, kMvsCross, 3),
                 shares_row("dodecahedron-frame", true, kMvsCross, 3), shares_row("moved-two-3", false, kBending, 3),
                 shares_row("moved-two-3", false, kMvsCross, 2)});
}

}  // namespace umbilic
