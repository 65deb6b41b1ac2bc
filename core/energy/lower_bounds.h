// SPDX-License-Identifier: MIT
/// \file
/// The energies that no closed surface of a given genus goes below, and the one below which none touches itself.
///
/// `willmore` W = integral of H^2:
///   genus 0: W >= 4 pi, attained by spheres alone (Willmore 1965).
///   genus >= 1: W >= 2 pi^2, attained by the Clifford torus (Marques & Neves 2014, Annals of Mathematics 179, for
///   embedded surfaces; the others have W >= 8 pi > 2 pi^2).
///   A surface that passes through one point k times has W >= 4 pi k (Li & Yau 1982, Inventiones 69). So one below 8 pi
///   is embedded: it neither touches nor crosses itself.
/// `bending` B = integral of k1^2 + k2^2 = (k1 + k2)^2 - 2 k1 k2 = 4 H^2 - 2 K. With Gauss & Bonnet, integral of K = 2
///   pi chi = 4 pi (1 - g), B = 4 W - 8 pi (1 - g):
///   genus 0: B >= 16 pi - 8 pi = 8 pi.
///   genus g >= 1: B >= 8 pi^2 + 8 pi (g - 1).
/// Functionals of third order are integrals of squares, times a power of the area: they are >= 0, as spheres, cyclides
/// and thinner
///   and thinner tori show that nothing better holds for all of them.
///
/// Surfaces of several components have the sum of their components' energies, and of their bounds.
#pragma once

#include <numbers>
#include <vector>

#include "energy/functional.h"

namespace umbilic {

/// A connected surface with less Willmore energy than this is embedded.
inline constexpr double kEmbeddedWillmore = 8 * std::numbers::pi;

/// Of one closed component of this genus >= 0.
constexpr double lower_bound(Functional functional, int genus) {
  constexpr double pi = std::numbers::pi;
  switch (functional) {
    case kWillmore: return genus == 0 ? 4 * pi : 2 * pi * pi;
    case kBending: return 4 * lower_bound(kWillmore, genus) - 8 * pi * (1 - genus);
    default: return 0;
  }
}

/// Of a weighted sum over components of these genera.
inline double lower_bound(const Weights& weights, const std::vector<int>& genera) {
  double bound = 0;
  for (int f = 0; f < kFunctionalCount; ++f) {
    if (weights[f] == 0) continue;
    for (const int genus : genera) bound += weights[f] * lower_bound(static_cast<Functional>(f), genus);
  }
  return bound;
}

}  // namespace umbilic
