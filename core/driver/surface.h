// SPDX-License-Identifier: MIT
/// \file
/// An evaluable mesh with everything that measures it: layout, evaluators by both rules, reports.
#pragma once

#include <memory>

#include "driver/report.h"
#include "driver/rules.h"
#include "energy/surface_energy.h"

namespace umbilic {

/// A cage refined to a level.
struct RefinedCage {
  int level;
  PolygonMesh mesh;
  Points control;
};

/// `cage` after `level` Catmull-Clark steps, or as many as it needs to be evaluable. Fails as `required_level`, and
/// where the mesh would have more than kMaxFaces faces.
inline constexpr int kMaxFaces = 2'000'000;
Result<RefinedCage> refine(const Cage& cage, int level);

class Surface {
 public:
  Surface(PolygonMesh mesh, CapKind cap, const Weights& weights);

  const PolygonMesh& mesh() const { return mesh_; }
  const PatchLayout& layout() const { return layout_; }
  const JetEvaluator& jets() const { return jets_; }
  const SurfaceEnergy& energy() const { return energy_; }

  /// All energies by the reporting rule; the quadrature error is that of the weighted functional.
  EnergyReport report(const Points& control) const;
  /// The weighted functional's value in a report.
  double objective(const EnergyReport& report) const;

 private:
  PolygonMesh mesh_;
  Weights weights_;
  PatchLayout layout_;
  JetEvaluator jets_;
  SurfaceEnergy energy_;
  mutable std::unique_ptr<JetEvaluator> reporting_jets_;
};

/// Whether third-order functionals diverge on the mesh with the cap; `error` names a vertex at fault.
bool diverges(const PolygonMesh& mesh, CapKind cap, const Weights& weights, Error& error);

}  // namespace umbilic
