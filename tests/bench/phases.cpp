// SPDX-License-Identifier: MIT
/// \file
/// The parts of one level of a run, with the kernels that a run takes.
#include "driver/tessellate.h"
#include "measure.h"
#include "mesh/hierarchy.h"
#include "optimize/sobolev.h"
#include "subjects.h"

namespace umbilic {

std::string phases() {
  const Weights weights = only(kMvsCross);
  const Cage cage = *generate_cage("two-3");
  const RefinedCage refined = genus_two(kThroughputLevel);
  std::vector<std::string> rows;
  const auto add = [&](const char* name, double seconds) {
    rows.push_back(fmt::format(R"({{"phase":"{}","seconds":{:.6g}}})", name, seconds));
  };
  const Surface surface(refined, CapKind::kSmooth, weights);
  const Unknowns unknowns{Coordinates(refined.mesh.vertex_count())};
  Points gradient;
  SobolevMetric metric(surface.energy(), unknowns);
  const double metric_seconds = best_seconds(
      [&] {
        SobolevMetric fresh(surface.energy(), unknowns);
        fresh.begin(refined.control);
        while (!fresh.advance()) {
        }
      },
      0.5, 1);
  metric.begin(refined.control);
  while (!metric.advance()) {
  }
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(refined.control.size());
  add("refine the cage", best_seconds([&] { (void)refine_to_evaluable(cage, kThroughputLevel, false); }));
  add("layout and tables", best_seconds([&] { Surface(refined, CapKind::kSmooth, weights); }));
  add("Sobolev metric, assembled and factored", metric_seconds);
  add("metric solve", best_seconds([&] { (void)metric.solve(right); }));
  add("energy and gradient", best_seconds([&] { surface.energy().evaluate(refined.control, &gradient); }));
  add("energy alone", best_seconds([&] { surface.energy().evaluate(refined.control, nullptr); }));
  (void)surface.report(refined.control);
  add("all energies by the reporting rule", best_seconds([&] { (void)surface.report(refined.control); }));
  add("limit mesh, 4 x 4 quads per patch", best_seconds([&] {
        (void)tessellate(surface.mesh(), surface.symmetry(), surface.layout(), refined.control, 4);
      }));
  return joined(rows);
}

}  // namespace umbilic
