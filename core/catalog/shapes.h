// SPDX-License-Identifier: MIT
/// \file
/// The catalog's rows and columns: shapes, functionals, which rows have which, and what the paper's Table 1 prints for
/// them.
///
/// Holes are open: N-sided patches whose minimizers continue what surrounds them with continuous curvature, since their
/// boundary holds the curvature of a saddle over the regular polygon. They are minimized by mvs_cross only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cage/generate.h"
#include "energy/functional.h"
#include "problem/constraints.h"

namespace umbilic::catalog {

/// Height of the corners of a hole, whose polygon has the radius 1.
inline constexpr double kHoleRise = 0.25;

struct CatalogShape {
  std::string name;
  std::string generator;  ///< its name for generate_cage
  int genus = 0;
  int junctions = 0;  ///< 0 if the shape is not a frame
  int arms = 0;       ///< number of arms at a junction
  int sides = 0;      ///< of a hole; 0 if the shape is closed
  bool frame() const { return junctions > 0; }
  bool hole() const { return sides > 0; }
};

struct CatalogFunctional {
  std::string name;
  Weights weights{};
};

/// The paper's shapes in its order, those that its text mentions, the dodecahedron, torus and sphere, and holes of 3 to
/// 8 sides.
const std::vector<CatalogShape>& catalog_shapes();

/// The paper's functionals, those that it leaves to future work, and bending + MVS_cross.
const std::vector<CatalogFunctional>& catalog_functionals();

/// Whether the catalog has an entry of the shape for the functional.
bool has_entry(const CatalogShape& shape, const CatalogFunctional& functional);

/// The options of the shape's cage, and what its minimizers keep.
CageOptions cage_options(const CatalogShape& shape);
Constraints constraints_of(const CatalogShape& shape);

/// The energy that Table 1 of Joshi & Sequin 2007 prints.
std::optional<double> paper_energy(const CatalogShape& shape, const CatalogFunctional& functional);

}  // namespace umbilic::catalog
