// SPDX-License-Identifier: MIT
/// \file
/// Refinement of cages, and reports.
#include "driver/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/hierarchy.h"

namespace umbilic {

Result<RefinedCage> refine(const Cage& cage, int level) {
  PolygonMesh mesh(cage);
  const Result<int> required = required_level(mesh);
  if (!required) return required.error();
  const int steps = std::max(level, *required);
  const double faces = steps == 0 ? mesh.face_count() : mesh.halfedge_count() * std::pow(4.0, steps - 1);
  if (faces > kMaxFaces) {
    return Error{fmt::format("level {} would have {:.3g} faces; at most {} are possible", steps, faces, kMaxFaces)};
  }
  Points control = cage.vertices;
  for (int i = 0; i < steps; ++i) {
    Refinement step = catmull_clark(mesh);
    control = (step.stencil * control).eval();
    mesh = std::move(step.mesh);
  }
  return RefinedCage{steps, std::move(mesh), std::move(control)};
}

bool diverges(const PolygonMesh& mesh, CapKind cap, const Weights& weights, Error& error) {
  if (cap != CapKind::kNone) return false;
  const auto third = std::find_if(weights.begin() + kMvs, weights.end(), [](double w) { return w != 0; });
  if (third == weights.end()) return false;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_extraordinary(v)) continue;
    error.message = fmt::format("{} diverges at extraordinary vertices (valence {}) with cap none; use smooth or flat",
                                kFunctionalNames[third - weights.begin()], mesh.valence(v));
    return true;
  }
  return false;
}

Surface::Surface(PolygonMesh mesh, CapKind cap, const Weights& weights)
    : mesh_(std::move(mesh)),
      weights_(weights),
      layout_(mesh_, cap),
      jets_(layout_, minimizing_rule(cap)),
      energy_(jets_, weights) {}

EnergyReport Surface::report(const Points& control) const {
  if (!reporting_jets_) reporting_jets_ = std::make_unique<JetEvaluator>(layout_, reporting_rule(layout_.cap()));
  const SurfaceIntegrals integrals = surface_integrals(*reporting_jets_, control);
  EnergyReport report{integrals.functionals, integrals.area, integrals.gaussian, 0};
  if (layout_.cap() == CapKind::kNone && !layout_.caps().empty()) {
    for (int i = 0; i < kFunctionalCount; ++i) {
      if (is_third_order(i)) report.functionals[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  report.quadrature_error = std::abs(objective(report) - energy_.evaluate(control, nullptr).energy);
  return report;
}

double Surface::objective(const EnergyReport& report) const {
  double sum = 0;
  for (int i = 0; i < kFunctionalCount; ++i) {
    if (weights_[i] != 0) sum += weights_[i] * report.functionals[i];
  }
  return sum;
}

}  // namespace umbilic
