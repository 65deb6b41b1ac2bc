// SPDX-License-Identifier: MIT
/// \file
/// Small cages made to break numerics: needles, noise, covers, spikes, twists, plates, and their like.
#pragma once

#include <string>
#include <vector>

#include "cage/cage.h"

namespace umbilic::test {

struct StressCage {
  std::string name;
  Cage cage;  ///< validated
};

/// At least 40, the same on every platform but for rounding.
const std::vector<StressCage>& stress_cages();

/// The one of this name.
const Cage& stress_cage(const std::string& name);

/// A box around the origin with these edges.
Cage box(double x, double y, double z);

/// Two apexes at +-height over an n-gon of radius 1.
Cage bipyramid(int n, double height);

/// A sphere whose `segments` >= 3 meridians wind `windings` times around the axis, with `rings` >= 2 rings between the
/// poles: branched at both of them where `windings` > 1.
Cage wound_sphere(int segments, int rings, int windings);

/// A net of quads around a torus with radii 1 and `ratio`, wound so many times around its tube.
Cage wound_torus(int major, int minor, double ratio, int windings);

/// With every point moved by up to `amount` in each coordinate.
Cage noisy(Cage cage, double amount, unsigned seed);

}  // namespace umbilic::test
