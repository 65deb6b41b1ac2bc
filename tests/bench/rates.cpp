// SPDX-License-Identifier: MIT
/// \file
/// The parts of levels of many kinds, measured beside what driver/level_work.h says of them.
#include <ctime>

#include "cages.h"
#include "driver/level_work.h"
#include "driver/rules.h"
#include "mesh/hierarchy.h"
#include "optimize/hessian_assembly.h"
#include "optimize/metric_rules.h"
#include "optimize/sobolev.h"
#include "subjects.h"

namespace umbilic {
namespace {

/// CPU seconds, so that what else the machine does leaves them alone: the best of several rounds.
template <class Work>
double cpu_seconds(const Work& work, double budget = 0.15, int rounds = 2) {
  double best = 1e300, total = 0;
  for (int i = 0; i < rounds || total < budget; ++i) {
    const std::clock_t begin = std::clock();
    work();
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    best = std::min(best, seconds);
    total += seconds + 1e-6;
  }
  return best;
}

template <class Part>
void build(Part& part) {
  while (!part.advance()) {
  }
}

std::string text_of(const SampleCounts& counts, std::string_view rule) {
  return fmt::format(R"("{}":[{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}])", rule, counts.regular, counts.capped,
                     counts.columns, counts.pairs, counts.entries);
}

std::string row(const std::string& name, bool symmetric, int level, int functional) {
  const Cage cage = *bench_cage(name);
  const Weights weights = only(functional);
  RefinedCage refined = *refine_to_evaluable(cage, level, symmetric);
  const double refining = cpu_seconds([&] { (void)refine_to_evaluable(cage, level, symmetric); });
  const double layout = cpu_seconds([&] { Surface(refined, CapKind::kSmooth, weights); });
  const Points control = refined.control;
  const int order = refined.symmetry.order;
  const Coordinates coordinates(refined.mesh, refined.symmetry);
  const Surface surface(std::move(refined), CapKind::kSmooth, weights);
  const Unknowns unknowns(coordinates);
  Points gradient;
  const double evaluation = cpu_seconds([&] { surface.energy().evaluate(control, &gradient); });
  (void)surface.report(control);
  const double report = cpu_seconds([&] { (void)surface.report(control); });
  HessianAssembly assembly(surface.layout(), unknowns, weights, hessian_rule(CapKind::kSmooth, weights));
  const double assembled = cpu_seconds([&] {
    assembly.begin(control);
    build(assembly);
  });
  SparseCholesky factor(SparseCholesky::Pivots::kPositive);
  const SparseCholesky::Matrix matrix = assembly.combine(0, 1);
  factor.factor(matrix);
  const double factored = cpu_seconds([&] { factor.factor(matrix); });
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(unknowns.count());
  const double solved = cpu_seconds([&] { (void)factor.solve(right); });
  SobolevMetric sobolev(surface.energy(), unknowns);
  const double metric = cpu_seconds([&] {
    sobolev.begin(control);
    build(sobolev);
  });
  const LevelSize size =
      level_size(level, surface.level(), surface.layout(), surface.mesh().face_count(), order, unknowns.count());
  const LevelWork hessian_work = level_work(size, weights, MetricChoice::kHessian);
  const LevelWork sobolev_work = level_work(size, weights, MetricChoice::kSobolev);
  return fmt::format(
      R"({{"cage":"{}","order":{},"level":{},"functional":"{}","faces":{},"patches":{},"unknowns":{},)"
      R"("counts":{{{},{}}},"refining":{:.4g},"layout":{:.4g},"report":{:.4g},"evaluation":{:.4g},"assembly":{:.4g},)"
      R"("factorization":{:.4g},"solution":{:.4g},"sobolev":{:.4g},)"
      R"("said":{{"setUp":{:.4g},"evaluation":{:.4g},"hessian":{:.4g},"sobolev":{:.4g}}}}})",
      name, order, level, kFunctionalNames[functional], surface.mesh().face_count(), surface.layout().patch_count(),
      unknowns.count(), text_of(sample_counts(size, minimizing_rule(CapKind::kSmooth, weights)), "minimizing"),
      text_of(sample_counts(size, kSobolevRule), "sobolev"), refining, layout, report, evaluation, assembled, factored,
      solved, metric, hessian_work.set_up, hessian_work.energy, hessian_work.metric, sobolev_work.metric);
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
