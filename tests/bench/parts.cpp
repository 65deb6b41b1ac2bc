// SPDX-License-Identifier: MIT
/// \file
/// Does each part of a level several times.
#include "parts.h"

#include "driver/rules.h"
#include "driver/surface.h"
#include "flops.h"
#include "mesh/hierarchy.h"
#include "optimize/hessian_assembly.h"
#include "optimize/sobolev.h"

namespace umbilic {
namespace {

template <class Part>
void build(Part& part) {
  while (!part.advance()) {
  }
}

}  // namespace

LevelParts measure_parts(const Cage& cage, bool symmetric, int level, const Weights& weights) {
  LevelParts parts;
  RefinedCage refined = *refine_to_evaluable(cage, level, symmetric);
  parts.refining = cpu_seconds([&] { (void)refine_to_evaluable(cage, level, symmetric); });
  parts.layout = cpu_seconds([&] { Surface(refined, CapKind::kSmooth, weights); });
  const Points control = refined.control;
  const int order = refined.symmetry.order;
  const Coordinates coordinates(refined.mesh, refined.symmetry);
  const Surface surface(std::move(refined), CapKind::kSmooth, weights);
  const Unknowns unknowns(coordinates);
  parts.size =
      level_size(level, surface.level(), surface.layout(), surface.mesh().face_count(), order, unknowns.count());

  Points gradient;
  parts.evaluation = cpu_seconds([&] { surface.energy().evaluate(control, &gradient); });
  parts.evaluation_flops = evaluation_flops(surface.layout(), minimizing_rule(CapKind::kSmooth, weights), weights);
  (void)surface.report(control);
  parts.report = cpu_seconds([&] { (void)surface.report(control); });

  HessianAssembly assembly(surface.layout(), unknowns, weights, hessian_rule(CapKind::kSmooth, weights));
  parts.assembly = cpu_seconds([&] {
    assembly.begin(control);
    build(assembly);
  });
  SparseCholesky factor(SparseCholesky::Pivots::kPositive);
  const SparseCholesky::Matrix matrix = assembly.combine(0, 1);
  factor.factor(matrix);
  parts.factorization = cpu_seconds([&] { factor.factor(matrix); });
  parts.factorization_flops = factorization_flops(matrix);
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(unknowns.count());
  parts.solution = cpu_seconds([&] { (void)factor.solve(right); });
  SobolevMetric sobolev(surface.energy(), unknowns);
  parts.sobolev = cpu_seconds([&] {
    sobolev.begin(control);
    build(sobolev);
  });
  return parts;
}

}  // namespace umbilic
