// SPDX-License-Identifier: MIT
/// \file
/// The term that keeps a level's parametrization even while it is minimized, and how it falls away.
///
/// An energy of the shape says almost nothing about how the parameters lie on it, so its soft directions are those that
/// move control points along the surface: without symmetry a minimization creeps along them. The integral of |Gamma|^2
/// (energy/densities.h) holds them. It is added with a weight that falls in stages, each of which starts where the one
/// before has nearly converged; in the last one it is 0, so that a level's energies are those of the functional alone.
#pragma once

#include <array>
#include <cstddef>

#include "energy/surface_energy.h"

namespace umbilic {

/// The term's weight in each stage, relative to energy / term at the stage's first surface. With larger factors between
/// the stages a surface leaves the one before by a long path; more stages cost more evaluations than they save.
inline constexpr std::array<double, 5> kParametrizationShares{0.4, 0.1, 0.025, 0.006, 0};

/// Tolerance of the stages before the last one, as in RunOptions.
inline constexpr double kStageTolerance = 1e-2;

class ParametrizationStages {
 public:
  /// In the last stage, with weight 0.
  ParametrizationStages() = default;

  /// Begins the first stage, at the surface with these control points.
  void begin(const SurfaceEnergy& energy, const Points& control);
  /// Begins the next stage.
  void advance(const SurfaceEnergy& energy, const Points& control);

  /// How many stages have begun.
  int begun() const { return begun_; }
  bool last() const { return stage_ + 1 == kParametrizationShares.size(); }
  /// The weight of the parametrization's density.
  double weight() const { return weight_; }

 private:
  void weigh(const SurfaceEnergy& energy, const Points& control);

  std::size_t stage_ = kParametrizationShares.size() - 1;
  int begun_ = 0;
  double weight_ = 0;
};

}  // namespace umbilic
