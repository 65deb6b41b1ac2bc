// SPDX-License-Identifier: MIT
/// \file
/// Moves points at random, and looks at what their energies do.
#include "driver/input_rounding.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "driver/level.h"

namespace umbilic {
namespace {

constexpr int kRoundings = 3;

/// Each coordinate elsewhere, evenly, within what its rounding leaves open.
Points unrounded(const RefinedCage& cage, const Points& rounding, std::mt19937& random) {
  Points control = cage.control;
  for (Eigen::Index i = 0; i < control.size(); ++i) {
    control.data()[i] += (2.0 * random() / std::mt19937::max() - 1) * rounding.data()[i];
  }
  return control;
}

}  // namespace

std::optional<FunctionalValues> input_rounding(const RefinedCage& cage, const Points& input, const Surface& surface,
                                               const EnergyReport& energies) {
  if (cage.placement.is_centred()) return std::nullopt;
  FunctionalValues largest;
  const Points rounding = cage.placement.rounding(input);
  std::mt19937 random(1);
  for (int copy = 0; copy < kRoundings; ++copy) {
    RefinedCage moved = cage;
    moved.control = unrounded(cage, rounding, random);
    const EnergyReport changed = surface.report(refine(std::move(moved), surface.level() - cage.level).control);
    for (int i = 0; i < kFunctionalCount; ++i) {
      const double energy = energies.functionals[i];
      const double change = std::abs(changed.functionals[i] - energy) / std::max(std::abs(energy), kEnergyFloor);
      if (!(change <= largest.values[i])) largest.values[i] = change;
    }
  }
  return largest;
}

}  // namespace umbilic
