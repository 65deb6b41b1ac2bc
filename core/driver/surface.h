// SPDX-License-Identifier: MIT
/// \file
/// An evaluable mesh with all that evaluates it: the layout, evaluators by both rules, and reports.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "cage/placement.h"
#include "driver/boundary_rows.h"
#include "driver/held_point.h"
#include "driver/rules.h"
#include "energy/lower_bounds.h"
#include "energy/surface_energy.h"
#include "mesh/coordinates.h"
#include "mesh/symmetry.h"
#include "optimize/closeness_term.h"
#include "problem/constraints.h"
#include "problem/energy_report.h"

namespace umbilic {

/// A cage refined to a level, in the unit coordinates of the cage that it comes from.
struct RefinedCage {
  int level;
  PolygonMesh mesh;
  Points control;
  SymmetryGroup symmetry;    ///< the symmetry that the optimizer keeps; C1 for none
  Placement placement{};     ///< from unit coordinates back to the cage's own
  std::vector<bool> held{};  ///< of each face: whether the surface over it stays; empty if all are free
  std::vector<HeldPoint> pins{};
  std::vector<BoundaryCondition>
      boundary{};                     ///< at each half-edge of the surface, see boundary_rows.h; empty if closed
  std::optional<double> closeness{};  ///< the weight of the term that pulls to the cage's own surface, if there is one
  /// Where something is held, or pulled back, or there is a boundary: the control points of the cage's own surface, its
  /// pure subdivision; else empty.
  Points own{};

  bool is_constrained() const { return own.size() > 0; }
};

inline constexpr int kMaxFaces = 2'000'000;

/// Of a cage after so many Catmull-Clark steps; a double, which does not overflow.
double faces_after(const PolygonMesh& cage, int steps);

/// The cage at level 0 with its symmetry group (C1 unless `symmetric`); its points are made exactly symmetric, except
/// those that held faces depend on. Of the symmetry, that part is left which keeps what is held. Fails as
/// `required_level` and `held_faces`, and if the mesh after `last_level` steps would have more than
/// kMaxFaces faces. Its unit coordinates are those of `placement`, by default the cage's own.
Result<RefinedCage> prepare(const Cage& cage, int last_level, bool symmetric, const Constraints& constraints = {},
                            const std::optional<Placement>& placement = {});
/// The cage after `steps` further Catmull-Clark steps.
RefinedCage refine(RefinedCage cage, int steps);
/// The control points that the surface over held faces depends on, which stay where the cage's own surface has them;
/// and those of holes beyond the first ring, on which no surface depends, so that no energy could tell where they go.
/// The mesh must be evaluable if faces are held.
HeldPoints held_points(const RefinedCage& cage, CapChoice cap);
/// The polygons of a mesh's surface, with corners in the order of its half-edges. Of an open surface that has been
/// optimized, this is not all: its ghosts are unknowns of their own, and a cage without them evaluates as the surface
/// with the standard ones (mesh/ghosts.h). A SurfaceState has them.
Cage to_cage(const PolygonMesh& mesh, Points control);

/// `cage` after `level` Catmull-Clark steps, or after as many as it needs to be evaluable. Fails as `prepare`.
Result<RefinedCage> refine_to_evaluable(const Cage& cage, int level, bool symmetric);

/// Where faces are held, what is minimized is the energy of the free faces. The factor area of third-order functionals
/// is then a constant, `fixed_area`, so that what is held does not pull on what is free to make it smaller. Reports are
/// about the whole surface, and have the minimized energies apart.
class Surface {
 public:
  /// For points with the symmetry of the cage, with a minimizing rule refined by `quadrature` steps.
  Surface(RefinedCage cage, CapChoice cap, const Weights& weights, int quadrature = 0,
          std::optional<double> fixed_area = {});

  const RefinedCage& cage() const { return cage_; }
  int level() const { return cage_.level; }
  const PolygonMesh& mesh() const { return cage_.mesh; }
  const SymmetryGroup& symmetry() const { return cage_.symmetry; }
  const Placement& placement() const { return cage_.placement; }
  /// The control points passed to the constructor.
  const Points& start() const { return cage_.control; }
  /// Of the free faces, one patch for each orbit.
  const PatchLayout& layout() const { return layout_; }
  /// Of all faces.
  const PatchLayout& whole_layout() const { return whole_ ? *whole_ : layout_; }
  bool holds_faces() const { return whole_.has_value(); }
  /// What pulls the surface to the cage's own; null if nothing does.
  const ClosenessTerm* closeness() const { return closeness_.get(); }
  /// The constant factor of third-order functionals, in unit coordinates, if there is one.
  std::optional<double> fixed_area() const { return fixed_area_; }
  const JetEvaluator& jets() const;
  const SurfaceEnergy& energy() const;

  /// Of each component.
  const std::vector<int>& genera() const { return genera_; }
  /// Of the weighted functional, see energy/lower_bounds.h; 0 where that is not the whole surface's.
  double lower_bound() const { return holds_faces() ? 0 : bound_of(weights_); }
  /// Rings of faces of the narrowest cap that is not held; 0 without caps.
  int narrowest_cap() const;
  /// How much the boundary turns (surface/boundary_turning.h); 0 if there is none.
  double turning(const Points& control) const;
  /// What the integral of the Gaussian curvature over the free faces and the turning of the boundary sum to, by Gauss &
  /// Bonnet's theorem.
  double expected_gaussian() const;

  /// All energies by the reporting rule, the area in the cage's own units; the quadrature error is that of the weighted
  /// functional.
  EnergyReport report(const Points& control) const;
  /// The weighted functional's value in a report.
  double objective(const EnergyReport& report) const;

 private:
  double in_own_units(double area) const { return std::ldexp(area, 2 * placement().exponent); }
  double bound_of(const Weights& weights) const {
    return mesh().is_open() ? 0 : umbilic::lower_bound(weights, genera_);
  }
  double willmore_by_minimizing_rule(const Points& control, const EnergyValue& value) const;
  /// Integrals by the reporting rule.
  SurfaceIntegrals whole_integrals(const Points& control) const;
  SurfaceIntegrals free_integrals(const Points& control) const;

  RefinedCage cage_;
  std::vector<int> genera_;
  Weights weights_;
  int quadrature_;
  std::optional<double> fixed_area_;
  PatchLayout layout_;
  std::optional<PatchLayout> whole_;  // if faces are held
  // Made on first use.
  mutable std::unique_ptr<JetEvaluator> jets_, reporting_jets_, whole_reporting_jets_;
  mutable std::unique_ptr<SurfaceEnergy> energy_;
  std::unique_ptr<ClosenessTerm> closeness_;
};

/// Whether third-order functionals diverge on the mesh with this cap; `error` then names a vertex that causes it.
bool diverges(const PolygonMesh& mesh, CapChoice cap, const Weights& weights, Error& error);

}  // namespace umbilic
