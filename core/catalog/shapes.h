// SPDX-License-Identifier: MIT
/// \file
/// The catalog's rows and columns: shapes, functionals, and what the paper's Table 1 prints for them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cage/generate.h"
#include "energy/functional.h"

namespace umbilic::catalog {

struct CatalogShape {
  std::string name;
  std::string generator;  ///< what generate_cage calls it
  int genus = 0;
  int junctions = 0;  ///< 0 for shapes that are no frames
  int arms = 0;       ///< that meet in a junction
  bool frame() const { return junctions > 0; }
};

struct CatalogFunctional {
  std::string name;
  Weights weights{};
};

/// The paper's shapes in its order, those that its text names, the dodecahedron, torus and sphere.
const std::vector<CatalogShape>& catalog_shapes();

/// The paper's functionals, those that it leaves to future work, and bending + MVS_cross.
const std::vector<CatalogFunctional>& catalog_functionals();

/// What Joshi & Sequin 2007, Table 1, print for the minimizer.
std::optional<double> paper_energy(const CatalogShape& shape, const CatalogFunctional& functional);

}  // namespace umbilic::catalog
