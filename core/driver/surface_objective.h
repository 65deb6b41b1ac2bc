// SPDX-License-Identifier: MIT
/// \file
/// The energy of a surface as a function of the optimizer's unknowns: control points, or those of a coarser mesh.
#pragma once

#include "energy/surface_energy.h"
#include "optimize/unknowns.h"
#include "solve/objective.h"

namespace umbilic {

/// Where the integral of the Gaussian curvature leaves 2 pi times the Euler characteristic, curvature hides between the
/// samples, as in the necks of a surface that falls apart, and the energy there is not the surface's: it counts as
/// infinite.
class SurfaceObjective : public Objective {
 public:
  /// `energy` and `unknowns` outlive the objective. The start is always finite where its energy is.
  SurfaceObjective(const SurfaceEnergy& energy, const Unknowns& unknowns, int euler_characteristic,
                   const Points& start);

  void evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const override;

  double start_energy() const { return start_energy_; }

 private:
  const SurfaceEnergy& energy_;
  const Unknowns& unknowns_;
  int euler_characteristic_;
  double start_energy_, largest_defect_;
  mutable Points control_, gradient_;
};

}  // namespace umbilic
