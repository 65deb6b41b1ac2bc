// SPDX-License-Identifier: MIT
/// \file
/// What the rounding of a cage's coordinates does to the energies of its surface.
///
/// A coordinate x in a file is some number within half a unit in its last place, 2^-53 |x|, of the one that was meant.
/// Relative to the cage's size that is 2^-53 offset / size: nothing for a cage about the origin, but 5e-8 where the
/// offset is 1e9 sizes. Control points that are off by d independently, h apart, change curvatures by about d / h^2 and
/// their derivatives by d / h^3, so that a fine mesh far from the origin has few true digits. How many depends on the
/// surface; so it is measured, on copies whose points are moved at random by as much.
#pragma once

#include <optional>

#include "driver/surface.h"

namespace umbilic {

/// EnergyReport::input_rounding of `energies`, those of `surface`: `cage` refined, whose points in its own coordinates
/// are `input`. The largest change of three copies, at the cost of as many reports; zero, and at no cost, for a cage
/// about the origin.
std::optional<FunctionalValues> input_rounding(const RefinedCage& cage, const Points& input, const Surface& surface,
                                               const EnergyReport& energies);

}  // namespace umbilic
