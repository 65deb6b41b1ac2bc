// SPDX-License-Identifier: MIT
/// \file
/// How each entry of the catalog is computed.
#pragma once

#include <optional>

#include "catalog/shapes.h"
#include "driver/run.h"

namespace umbilic::catalog {

struct EntrySettings {
  CageOptions cage;
  RunOptions run;
  /// Where certificates are wanted: they are taken on the finest level of at most this many faces.
  std::optional<int> certified_faces;
  /// The other family of cages for the same shape, and the last level for it.
  std::optional<FrameFamily> second_family;
  int second_last_level = 0;
};

/// Levels from 0 to 3 for bending, to 4 where three levels leave an error above 0.05 % and for third-order functionals;
/// fewer where the infimum is known and not attained, or 0. `last_level` caps them.
EntrySettings entry_settings(const CatalogShape& shape, const CatalogFunctional& functional, int last_level);

/// The paper's figure 3: one shape from a thin and a fat cage.
struct Start {
  std::string shape;
  std::string functional;
  double thickness;
};

const std::vector<Start>& catalog_starts();
EntrySettings start_settings(const Start& start, int last_level);

const CatalogShape& shape_called(std::string_view name);
const CatalogFunctional& functional_called(std::string_view name);

}  // namespace umbilic::catalog
