// SPDX-License-Identifier: MIT
/// \file
/// The energy of a surface as a function of the optimizer's unknowns: its control points, or those of a coarser mesh.
#pragma once

#include <functional>

#include "energy/surface_energy.h"
#include "optimize/closeness_term.h"
#include "optimize/unknowns.h"
#include "solve/objective.h"

namespace umbilic {

/// Where the integral of the Gaussian curvature leaves what the topology makes it (driver/gauss_bonnet.h), curvature
/// hides between the samples, as in the necks of a surface that falls apart, and the energy there is not the surface's:
/// it counts as infinite, so that the line search steps back. So does an energy far below what any closed surface has.
/// A start that is itself at fault counts as it is, and what follows may be little worse.
class SurfaceObjective : public Objective {
 public:
  /// `energy` and `unknowns` must outlive the objective; `gaussian` is what the integral of the Gaussian curvature must
  /// be. At the start the value is finite whenever the energy is.
  /// Of an open surface it is less by what `turning` says for the control points. `closeness` is added to the energy.
  SurfaceObjective(const SurfaceEnergy& energy, const Unknowns& unknowns, double gaussian, const Points& start,
                   double lower_bound = 0, std::function<double(const Points&)> turning = {},
                   const ClosenessTerm* closeness = nullptr);

  void evaluate(const Eigen::VectorXd& unknowns, Evaluation& result) const override;

  /// The optimizer has gone to the point that was evaluated last: from now on none may have a much larger defect.
  void accept() const;

  /// The weight of the parametrization's density (driver/parametrization.h), which is added to the energy; at first 0.
  void set_parametrization(double weight) { parametrization_ = weight; }
  /// That term at the point that was evaluated last.
  double last_parametrization() const { return last_parametrization_; }

  double start_energy() const { return start_energy_; }
  /// Whether the samples see all curvature of the start.
  bool start_is_whole() const { return start_is_whole_; }

 private:
  double defect(const EnergyValue& value, const Points& control) const;

  const SurfaceEnergy& energy_;
  const Unknowns& unknowns_;
  double gaussian_;
  std::function<double(const Points&)> turning_;
  const ClosenessTerm* closeness_;
  double start_energy_, least_energy_;
  bool start_is_whole_;
  double parametrization_ = 0;
  mutable double largest_defect_, last_defect_ = 0, last_parametrization_ = 0;
  mutable Points control_, gradient_;
};

}  // namespace umbilic
