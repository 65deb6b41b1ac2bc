// SPDX-License-Identifier: MIT
/// \file
/// What is known in theory about the catalog's minimizers: smallest energies among surfaces with the shape's symmetry,
/// and infima that no surface attains.
#pragma once

#include <optional>
#include <string>

#include "catalog/shapes.h"

namespace umbilic::catalog {

struct ExactEnergy {
  double energy;       ///< the minimum or infimum
  double error;        ///< error of the number
  bool attained;       ///< whether some surface has this energy
  std::string source;  ///< where it is from, a short phrase
};

/// Bending of Lawson's minimal surface xi_{genus,1} of the 3-sphere, stereographically projected: 4 W - 8 pi (1 -
/// genus), W its area. Genus 2 and 3: numerical areas (Hsu, Kusner & Sullivan 1992, and to all digits given here by
/// discretizations that converge); from genus 4 on W = 8 pi (1 - ln 2 t - 9/4 zeta(3) t^3 - O(t^5)), t = 1/(2 (genus +
/// 1)) (Heller, Heller & Traizet 2021), where the coefficient of t^5 is taken to be at most 4, as in the areas of genus
/// 2 and 3. Nothing for other genera.
std::optional<ExactEnergy> lawson_bending(int genus);

/// The known energy of this entry, or nothing.
std::optional<ExactEnergy> exact_energy(const CatalogShape& shape, const CatalogFunctional& functional);

}  // namespace umbilic::catalog
