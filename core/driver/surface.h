// SPDX-License-Identifier: MIT
/// \file
/// An evaluable mesh with all that evaluates it: the layout, evaluators by both rules, and reports.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cage/placement.h"
#include "driver/rules.h"
#include "energy/lower_bounds.h"
#include "energy/surface_energy.h"
#include "mesh/symmetry.h"
#include "problem/report.h"

namespace umbilic {

/// A cage refined to a level, in the unit coordinates of the cage that it comes from.
struct RefinedCage {
  int level;
  PolygonMesh mesh;
  Points control;
  SymmetryGroup symmetry;  ///< the symmetry that the optimizer keeps; C1 for none
  Placement placement{};   ///< from unit coordinates back to the cage's own
};

inline constexpr int kMaxFaces = 2'000'000;

/// Of a cage after so many Catmull-Clark steps; a double, which does not overflow.
double faces_after(const PolygonMesh& cage, int steps);

/// A cage, with its symmetry where that is known, so many Catmull-Clark steps from the one that levels count from;
/// in its own coordinates.
struct StartingCage {
  const Cage& cage;
  std::optional<SymmetryGroup> symmetry;
  int level = 0;
};

/// Refuses open cages, as long as meshes must be closed. Empty for a closed cage.
std::optional<Error> refuse_open(const Cage& cage);

/// The cage at level 0 with its symmetry group (C1 unless `symmetric`); its points are made exactly symmetric. Fails as
/// `refuse_open`, as `required_level`, and if the mesh after `last_level` steps would have more than kMaxFaces faces.
Result<RefinedCage> prepare(const StartingCage& start, int last_level, bool symmetric);
/// The cage after `steps` further Catmull-Clark steps.
RefinedCage refine(RefinedCage cage, int steps);
/// The polygons of a mesh, with corners in the order of its half-edges.
Cage to_cage(const PolygonMesh& mesh, Points control);

/// `cage` after `level` Catmull-Clark steps, or after as many as it needs to be evaluable. Fails as `prepare`.
Result<RefinedCage> refine_to_evaluable(const Cage& cage, int level, bool symmetric);

class Surface {
 public:
  /// For points with the symmetry of the cage, with a minimizing rule refined by `quadrature` steps.
  Surface(RefinedCage cage, CapKind cap, const Weights& weights, int quadrature = 0);

  int level() const { return cage_.level; }
  const PolygonMesh& mesh() const { return cage_.mesh; }
  const SymmetryGroup& symmetry() const { return cage_.symmetry; }
  const Placement& placement() const { return cage_.placement; }
  /// The control points passed to the constructor.
  const Points& start() const { return cage_.control; }
  /// Has one patch for each orbit of faces.
  const PatchLayout& layout() const { return layout_; }
  const JetEvaluator& jets() const;
  const SurfaceEnergy& energy() const;

  /// Of each component.
  const std::vector<int>& genera() const { return genera_; }
  /// Of the weighted functional, see energy/lower_bounds.h.
  double lower_bound() const { return umbilic::lower_bound(weights_, genera_); }

  /// All energies by the reporting rule, the area in the cage's own units; the quadrature error is that of the weighted
  /// functional.
  EnergyReport report(const Points& control) const;
  /// The weighted functional's value in a report.
  double objective(const EnergyReport& report) const;

 private:
  double willmore_by_minimizing_rule(const Points& control, const EnergyValue& value) const;

  RefinedCage cage_;
  std::vector<int> genera_;
  Weights weights_;
  int quadrature_;
  PatchLayout layout_;
  // Made on first use.
  mutable std::unique_ptr<JetEvaluator> jets_, reporting_jets_;
  mutable std::unique_ptr<SurfaceEnergy> energy_;
};

/// Whether third-order functionals diverge on the mesh with this cap; `error` then names a vertex that causes it.
bool diverges(const PolygonMesh& mesh, CapKind cap, const Weights& weights, Error& error);

}  // namespace umbilic
