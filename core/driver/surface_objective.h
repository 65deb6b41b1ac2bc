// SPDX-License-Identifier: MIT
/// \file
/// The energy of a surface as a function of the optimizer's unknowns: the coordinates of the control points, point by
/// point. Reduced coordinates (control points = B unknowns) belong here.
#pragma once

#include "energy/surface_energy.h"
#include "optimize/objective.h"

namespace umbilic {

class SurfaceObjective : public Objective {
 public:
  /// `energy` outlives the objective.
  explicit SurfaceObjective(const SurfaceEnergy& energy) : energy_(energy) {}

  void evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const override;

  static Eigen::VectorXd unknowns(const Points& control);
  static Points control(const Eigen::VectorXd& unknowns);

 private:
  const SurfaceEnergy& energy_;
};

}  // namespace umbilic
