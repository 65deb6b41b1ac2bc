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
  std::string generator;  ///< its name for generate_cage
  int genus = 0;
  int junctions = 0;  ///< 0 if the shape is not a frame
  int arms = 0;       ///< number of arms at a junction
  bool frame() const { return junctions > 0; }
};

struct CatalogFunctional {
  std::string name;
  Weights weights{};
};

/// The paper's shapes in its order, those that its text mentions, and the dodecahedron, torus and sphere.
const std::vector<CatalogShape>& catalog_shapes();

/// The paper's functionals, those that it leaves to future work, and bending + MVS_cross.
const std::vector<CatalogFunctional>& catalog_functionals();

/// The energy that Table 1 of Joshi & Sequin 2007 prints.
std::optional<double> paper_energy(const CatalogShape& shape, const CatalogFunctional& functional);

}  // namespace umbilic::catalog
