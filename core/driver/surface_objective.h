// SPDX-License-Identifier: MIT
/// \file
/// The energy of a surface as a function of the optimizer's unknowns: control points = offset + B unknowns.
#pragma once

#include "energy/surface_energy.h"
#include "mesh/coordinates.h"
#include "optimize/objective.h"

namespace umbilic {

class SurfaceObjective : public Objective {
 public:
  /// `energy` and `coordinates` outlive the objective.
  SurfaceObjective(const SurfaceEnergy& energy, const Coordinates& coordinates)
      : energy_(energy), coordinates_(coordinates) {}

  void evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const override;

 private:
  const SurfaceEnergy& energy_;
  const Coordinates& coordinates_;
  mutable Points control_, gradient_;
};

}  // namespace umbilic
