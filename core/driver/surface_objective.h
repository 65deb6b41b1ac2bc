// SPDX-License-Identifier: MIT
/// \file
/// The energy of a surface as a function of the optimizer's unknowns: control points, or those of a coarser mesh.
#pragma once

#include "energy/surface_energy.h"
#include "optimize/objective.h"
#include "optimize/unknowns.h"

namespace umbilic {

class SurfaceObjective : public Objective {
 public:
  /// `energy` and `unknowns` outlive the objective.
  SurfaceObjective(const SurfaceEnergy& energy, const Unknowns& unknowns) : energy_(energy), unknowns_(unknowns) {}

  void evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const override;

 private:
  const SurfaceEnergy& energy_;
  const Unknowns& unknowns_;
  mutable Points control_, gradient_;
};

}  // namespace umbilic
