// SPDX-License-Identifier: MIT
/// \file
/// The parts of levels of many kinds, measured beside what driver/level_work.h says of them.
#include "cages.h"
#include "driver/level_work.h"
#include "driver/rules.h"
#include "optimize/metric_rules.h"
#include "parts.h"
#include "subjects.h"

namespace umbilic {
namespace {

std::string text_of(const SampleCounts& counts, std::string_view rule) {
  return fmt::format(R"("{}":[{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}])", rule, counts.regular, counts.capped,
                     counts.columns, counts.pairs, counts.entries);
}

std::string row(const std::string& name, bool symmetric, int level, int functional) {
  const Weights weights = only(functional);
  const LevelParts parts = measure_parts(*bench_cage(name), symmetric, level, weights);
  const LevelSize& size = parts.size;
  const LevelWork hessian_work = level_work(size, weights, MetricChoice::kHessian);
  const LevelWork sobolev_work = level_work(size, weights, MetricChoice::kSobolev);
  return fmt::format(
      R"({{"cage":"{}","order":{},"level":{},"functional":"{}","faces":{},"patches":{},"unknowns":{},)"
      R"("counts":{{{},{}}},"refining":{:.4g},"layout":{:.4g},"report":{:.4g},"evaluation":{:.4g},"assembly":{:.4g},)"
      R"("factorization":{:.4g},"solution":{:.4g},"sobolev":{:.4g},)"
      R"("said":{{"setUp":{:.4g},"evaluation":{:.4g},"hessian":{:.4g},"sobolev":{:.4g}}}}})",
      name, size.order, level, kFunctionalNames[functional], size.mesh_faces, size.patches(), size.unknowns,
      text_of(sample_counts(size, minimizing_rule(CapKind::kSmooth, weights)), "minimizing"),
      text_of(sample_counts(size, kSobolevRule), "sobolev"), parts.refining, parts.layout, parts.report,
      parts.evaluation, parts.assembly, parts.factorization, parts.solution, parts.sobolev, hessian_work.set_up,
      hessian_work.energy, hessian_work.metric, sobolev_work.metric);
}

}  // namespace

std::string rates() {
  std::vector<std::string> rows;
  for (const int functional : {kBending, kMvsCross}) {
    for (const auto& [cage, last] :
         {std::pair("two-3", 4), std::pair("cube", 4), std::pair("torus", 3), std::pair("dodecahedron-frame", 3)})
      for (int level = 1; level <= last; ++level) rows.push_back(row(cage, true, level, functional));
    for (const auto& [cage, last] : {std::pair("two-3", 3), std::pair("cube", 4), std::pair("torus", 3),
                                     std::pair("two-4", 3), std::pair("tetrahedron-frame", 3)})
      for (int level = 1; level <= last; ++level) rows.push_back(row(cage, false, level, functional));
  }
  return joined(rows);
}

}  // namespace umbilic
